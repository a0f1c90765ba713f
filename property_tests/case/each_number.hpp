#pragma once
/// \file
/// The numbers of a shape, one after the other in the order of the format, through ShapeFormat alone.

#include <string_view>
#include <type_traits>

#include "case/shape_format.hpp"

namespace rayproof {

/// Calls `act(element)` for every component of a vector, column of a matrix, or element of a list.
void each_element(auto& value, auto&& act) {
  if constexpr (requires { value.length(); }) {
    for (int i = 0; i < value.length(); ++i) act(value[i]);
  } else if constexpr (requires { value.begin(); }) {
    for (auto& element : value) act(element);
  } else {
    act(value.x);
    act(value.y);
  }
}

/// Calls `act(number)` for every number of `value`: a number, a vector, a list of them, or a shape.
template <class V>
void each_number(V& value, auto&& act) {
  using Value = std::remove_const_t<V>;
  const auto descend = [&](auto& part) { each_number(part, act); };
  if constexpr (std::is_same_v<Value, double>) {
    act(value);
  } else if constexpr (requires { ShapeFormat<Value>::type; }) {
    ShapeFormat<Value>::fields(value, [&](const char* /*name*/, auto& field) { descend(field); });
  } else if constexpr (!std::is_same_v<Value, bool>) {
    each_element(value, descend);
  }
}

/// The shape, or a point and a polygon, in a scene `factor` times as large about the origin of coordinates:
/// all its numbers are lengths, but for a field named normal, which has no length to grow.
template <class S>
[[nodiscard]] S grown(S shape, double factor) {
  ShapeFormat<S>::fields(shape, [factor](std::string_view name, auto& value) {
    if (name != "normal") each_number(value, [factor](double& x) { x *= factor; });
  });
  return shape;
}

}  // namespace rayproof
