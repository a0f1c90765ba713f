#include <cmath>

#include "viz/render/bounds.hpp"

namespace rayproof::render {

RayAgainstBoxes::RayAgainstBoxes(const Ray<double>& ray) : ray_(ray) {
  for (int i = 0; i < 3; ++i) {
    const double o = std::abs(ray.origin[i]), d = std::abs(ray.direction[i]);
    const bool is_sound = o < largest_sound && d < largest_sound && (d > 1 / largest_sound || d == 0);
    axes_[static_cast<std::size_t>(i)] = !is_sound ? AxisState::unknown
                                         : d == 0  ? AxisState::parallel
                                                   : AxisState::crossed;
    inverse_[i] = 1 / ray.direction[i];
  }
}

std::optional<double> RayAgainstBoxes::entry(const Bounds& bounds, double t_max) const {
  const auto doubt = [](double t) { return 0x1p-50 * std::abs(t) + 0x1p-1000; };
  double first = ray_.t_min;
  double last = std::min(ray_.t_max, t_max);
  for (int i = 0; i < 3; ++i) {
    const double low = bounds.low[i], high = bounds.high[i], o = ray_.origin[i];
    const AxisState axis = axes_[static_cast<std::size_t>(i)];
    if (axis == AxisState::unknown) continue;
    if (axis == AxisState::parallel) {
      if (o < low || high < o) return std::nullopt;
      continue;
    }
    const bool is_upward = inverse_[i] > 0;
    const double in = ((is_upward ? low : high) - o) * inverse_[i];
    const double out = ((is_upward ? high : low) - o) * inverse_[i];
    first = std::max(first, in - doubt(in));
    last = std::min(last, out + doubt(out));
  }
  if (first > last) return std::nullopt;
  return first;
}

}  // namespace rayproof::render
