#pragma once
/// \file
/// The numbers of a shape, one after the other in the order of the format, through ShapeFormat alone.

#include <rayproof/polygon.hpp>
#include <type_traits>

#include "case/shapes.hpp"

namespace rayproof {

/// Calls `act(number)` for every number of `value`: a number, a vector, a list of them, or a shape.
template <class V, class Act>
void each_number(V& value, Act&& act) {
  using Value = std::remove_const_t<V>;
  if constexpr (std::is_same_v<Value, double>) {
    act(value);
  } else if constexpr (std::is_same_v<Value, glm::dvec3>) {
    for (int axis = 0; axis < 3; ++axis) act(value[axis]);
  } else if constexpr (std::is_same_v<Value, Vec2<double>>) {
    act(value.x);
    act(value.y);
  } else if constexpr (requires { ShapeFormat<Value>::type; }) {
    ShapeFormat<Value>::fields(value, [&](const char* /*name*/, auto& field) { each_number(field, act); });
  } else if constexpr (!std::is_same_v<Value, bool>) {
    for (auto& element : value) each_number(element, act);
  }
}

}  // namespace rayproof
