#pragma once
#include <rayproof/disk.hpp>

#include "case/shape_format.hpp"

namespace rayproof {

template <>
struct ShapeFormat<Disk<double>> {
  static constexpr const char* type = "disk";

  static void fields(auto& disk, auto&& visit) {
    visit("center", disk.center);
    visit("normal", disk.normal);
    visit("radius", disk.radius);
  }

  /// A point near which the whole shape lies, for a sentence that says how far away it is.
  static glm::dvec3 middle(const Disk<double>& disk) { return disk.center; }

  static std::string in_words(const Disk<double>& disk, auto&& show) {
    return "a disk of radius " + show(disk.radius);
  }

  static void validate(const Disk<double>& disk) {
    if (disk.normal == glm::dvec3(0)) throw Refusal("normal", "the disk's normal must not be zero");
    if (disk.radius < 0) throw Refusal("radius", "the disk's radius must not be negative");
  }
};

}  // namespace rayproof
