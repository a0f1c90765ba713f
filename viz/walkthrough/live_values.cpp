#include "viz/walkthrough/stage_values.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <rayproof/ray.hpp>

#include "viz/trace/numbers.hpp"

namespace rayproof::viz {
namespace {

/// The polynomial at t by Horner's rule in T, its coefficients rounded to T first.
template <class T>
T value_at(const std::vector<double>& coefficients, double t) {
  T sum(0);
  for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) sum = sum * T(t) + T(*c);
  return sum;
}

glm::dvec3 point_on(const StageSlider& slider, double t, Precision precision) {
  return in_precision(precision, [&]<class T>(T) {
    const Ray<T> ray{vec3<T>(slider.origin), vec3<T>(slider.direction)};
    return glm::dvec3(point_at(ray, T(t)));
  });
}

}  // namespace

double neighbour_of(double t, int count, Precision precision) {
  return in_precision(precision, [&]<class T>(T) {
    const T end = count < 0 ? -std::numeric_limits<T>::infinity() : std::numeric_limits<T>::infinity();
    T next = T(t);
    for (int i = 0; i < std::abs(count); ++i) next = std::nextafter(next, end);
    return double{next};
  });
}

std::vector<LiveValue> live_values(const StageSlider& slider, double t, Precision precision) {
  const bool is_float = precision == Precision::float32;
  constexpr int float_bits = std::numeric_limits<float>::digits;
  std::vector<LiveValue> values;
  if (slider.shows_point) {
    const glm::dvec3 p = point_on(slider, t, precision);
    const auto exact = [&](int axis) {
      const Shadow real = Shadow(slider.origin[axis]) + Shadow(t) * Shadow(slider.direction[axis]);
      return exact_beside(real, p[axis], float_bits);
    };
    values.push_back({"p(t)", shown(p, precision),
                      is_float ? fmt::format("({}, {}, {})", exact(0), exact(1), exact(2)) : ""});
  }
  for (const StageReadout& readout : slider.readouts) {
    const auto& c = readout.coefficients;
    const double rounded = in_precision(precision, [&]<class T>(T) { return double{value_at<T>(c, t)}; });
    values.push_back({readout.label, shown(rounded, precision),
                      is_float ? exact_beside(value_at<Shadow>(c, t), rounded, float_bits) : ""});
  }
  return values;
}

}  // namespace rayproof::viz
