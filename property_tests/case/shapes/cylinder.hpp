#pragma once
#include <rayproof/cylinder.hpp>

#include "case/shape_format.hpp"

namespace rayproof {

template <>
struct ShapeFormat<Cylinder<double>> {
  static constexpr const char* type = "cylinder";

  template <class S, class Visit>
  static void fields(S& cylinder, Visit&& visit) {
    visit("rx", cylinder.rx);
    visit("ry", cylinder.ry);
    visit("height", cylinder.height);
    visit("capped", cylinder.capped);
  }

  static void validate(const Cylinder<double>& cylinder) {
    if (!(cylinder.rx > 0)) throw Refusal("rx", "the cylinder's rx must be positive");
    if (!(cylinder.ry > 0)) throw Refusal("ry", "the cylinder's ry must be positive");
    if (cylinder.height < 0) throw Refusal("height", "the cylinder's height must not be negative");
  }
};

}  // namespace rayproof
