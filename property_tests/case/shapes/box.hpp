#pragma once
#include <rayproof/box.hpp>

#include "case/shape_format.hpp"

namespace rayproof {

template <>
struct ShapeFormat<Box<double>> {
  static constexpr const char* type = "box";

  static void fields(auto& box, auto&& visit) {
    visit("min", box.min);
    visit("max", box.max);
  }

  static std::string in_words(const Box<double>& box, auto&& show) {
    const glm::dvec3 size = box.max - box.min;
    return "a box of " + show(size.x) + " by " + show(size.y) + " by " + show(size.z);
  }

  static void validate(const Box<double>& box) {
    for (int axis = 0; axis < 3; ++axis) {
      if (box.min[axis] > box.max[axis])
        throw Refusal("min", "the box's min must not be greater than its max on any axis");
    }
  }
};

}  // namespace rayproof
