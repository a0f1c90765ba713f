#pragma once
#include <rayproof/cylinder.hpp>

#include "case/shape_format.hpp"

namespace rayproof {

template <>
struct ShapeFormat<Cylinder<double>> {
  static constexpr const char* type = "cylinder";

  static void fields(auto& cylinder, auto&& visit) {
    visit("rx", cylinder.rx);
    visit("ry", cylinder.ry);
    visit("height", cylinder.height);
    visit("capped", cylinder.capped);
  }

  static glm::dvec3 middle(const Cylinder<double>& cylinder) { return {0, 0, cylinder.height / 2}; }

  static std::string in_words(const Cylinder<double>& cylinder, auto&& show) {
    const std::string size = cylinder.rx == cylinder.ry
                                 ? "radius " + show(cylinder.rx)
                                 : "radii " + show(cylinder.rx) + " and " + show(cylinder.ry);
    return (cylinder.capped ? "a capped cylinder of " : "an open cylinder of ") + size;
  }

  static void validate(const Cylinder<double>& cylinder) {
    if (!(cylinder.rx > 0)) throw Refusal("rx", "the cylinder's rx must be positive");
    if (!(cylinder.ry > 0)) throw Refusal("ry", "the cylinder's ry must be positive");
    if (cylinder.height < 0) throw Refusal("height", "the cylinder's height must not be negative");
  }
};

}  // namespace rayproof
