#pragma once
/// \file
/// Plain floating point that remembers what a kernel names: how a test learns a plain run's own numbers.

#include <cmath>
#include <rayproof/arithmetic.hpp>
#include <rayproof/method/narration.hpp>
#include <rayproof/vec3.hpp>
#include <string>
#include <utility>
#include <vector>

namespace rayproof {

/// A `T` and nothing else: every operation is T's own.
template <std::floating_point T>
struct Heard {
  using Plain = T;

  T value{};

  Heard() = default;
  template <class U>
  requires std::is_arithmetic_v<U> Heard(U number) : value(static_cast<T>(number)) {}

  friend Heard operator-(Heard x) { return -x.value; }
  friend Heard operator+(Heard x, Heard y) { return x.value + y.value; }
  friend Heard operator-(Heard x, Heard y) { return x.value - y.value; }
  friend Heard operator*(Heard x, Heard y) { return x.value * y.value; }
  friend Heard operator/(Heard x, Heard y) { return x.value / y.value; }
  friend bool operator<(Heard x, Heard y) { return x.value < y.value; }
  friend bool operator>(Heard x, Heard y) { return x.value > y.value; }
  friend bool operator<=(Heard x, Heard y) { return x.value <= y.value; }
  friend bool operator>=(Heard x, Heard y) { return x.value >= y.value; }
  friend bool operator==(Heard x, Heard y) { return x.value == y.value; }
  friend bool operator!=(Heard x, Heard y) { return x.value != y.value; }

  /// What was named, in the order of naming.
  static inline std::vector<std::pair<std::string, double>> names{};
};

template <std::same_as<float> T>
[[nodiscard]] Heard<double> widen(Heard<T> x) {
  return x.value;
}
template <std::same_as<double> T>
[[nodiscard]] Heard<float> narrow(Heard<T> x) {
  return static_cast<float>(x.value);
}

template <class T>
[[nodiscard]] Heard<T> select(bool mask, Heard<T> yes, Heard<T> no) {
  return mask ? yes : no;
}
template <class T>
[[nodiscard]] Heard<T> sqrt(Heard<T> x) {
  return sqrt(x.value);
}
template <class T>
[[nodiscard]] Heard<T> abs(Heard<T> x) {
  return abs(x.value);
}
template <class T>
[[nodiscard]] Heard<T> copysign(Heard<T> x, Heard<T> sign) {
  return copysign(x.value, sign.value);
}
template <class T>
[[nodiscard]] Heard<T> fma(Heard<T> x, Heard<T> y, Heard<T> z) {
  return fma(x.value, y.value, z.value);
}
template <class T>
[[nodiscard]] Heard<T> min(Heard<T> x, Heard<T> y) {
  return min(x.value, y.value);
}
template <class T>
[[nodiscard]] Heard<T> max(Heard<T> x, Heard<T> y) {
  return max(x.value, y.value);
}
template <class T>
[[nodiscard]] Heard<T> exponent(Heard<T> x) {
  return exponent(x.value);
}
template <class T>
[[nodiscard]] Heard<T> scale_exponent(Heard<T> x, Heard<T> e) {
  return scale_exponent(x.value, e.value);
}
template <class T>
[[nodiscard]] Heard<T> floor(Heard<T> x) {
  return floor(x.value);
}

template <class T>
[[nodiscard]] Heard<T> named(const char* name, Heard<T> value) {
  Heard<T>::names.emplace_back(name, static_cast<double>(value.value));
  return value;
}
template <class T>
[[nodiscard]] Vec3<Heard<T>> named(const char* name, Vec3<Heard<T>> v) {
  const std::string text = name;
  for (const auto& [axis, component] : {std::pair{".x", v.x}, {".y", v.y}, {".z", v.z}}) {
    Heard<T>::names.emplace_back(text + axis, static_cast<double>(component.value));
  }
  return v;
}

}  // namespace rayproof
