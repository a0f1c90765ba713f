#include "viz/player/ray_handles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "case/json/number_text.hpp"
#include "case/reader.hpp"
#include "case/writer.hpp"
#include "viz/drawing/clip.hpp"

namespace rayproof::viz {
namespace {

/// Room that a handle wants at the frame's border.
constexpr double frame_inset = 14;

/// Whether the stage's slider runs along the ray of its case, so that the scene shows that ray.
bool shows_ray(const StageSlider& slider, const Ray<double>& ray) {
  return slider.shows_point && slider.origin == ray.origin && slider.direction == ray.direction;
}

/// The last t up to `to` at which the ray is inside the frame, where that is beyond `from`.
std::optional<double> last_t_in(const PixelBox& frame, const ScreenProjection& projection,
                                const Ray<double>& ray, double from, double to) {
  const auto seen = [&](double t) { return projection.to_pixels(ray.origin + t * ray.direction); };
  const auto parts = clip_line({seen(from), seen(to)}, frame);
  if (parts.empty()) return std::nullopt;
  const Point a = seen(from);
  const Point b = seen(to);
  const Point end = parts.back().back();
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  if (!(length > 0)) return std::nullopt;
  return from + (to - from) * (std::hypot(end.x - a.x, end.y - a.y) / length);
}

std::vector<Handle> ray_handles(const Ray<double>& ray, const StageSlider& slider,
                                const ScreenProjection& projection) {
  const PixelBox frame{projection.frame.left + frame_inset, projection.frame.top + frame_inset,
                       projection.frame.width - 2 * frame_inset, projection.frame.height - 2 * frame_inset};
  std::vector<Handle> handles;
  if (frame.holds(projection.to_pixels(ray.origin))) handles.push_back({Grip::origin, ray.origin, 0});
  const double from = std::isfinite(ray.t_min) ? ray.t_min : slider.from;
  const auto t = last_t_in(frame, projection, ray, from, std::max(slider.to, from));
  if (t && *t != 0) handles.push_back({Grip::tip, ray.origin + *t * ray.direction, *t});
  return handles;
}

/// `next` with as few decimals as distinguish it from its neighbours; `old` where it did not move.
double short_decimal(double old, double next, double resolution) {
  if (!(std::abs(next - old) >= resolution / 2)) return old;
  const double digits = -std::floor(std::log10(resolution));
  if (!(digits >= 0 && digits < 300)) return std::isfinite(next) ? std::nearbyint(next) : next;
  return parse_number(fmt::format("{:.{}f}", next, static_cast<int>(digits))).value_or(next);
}

glm::dvec3 short_decimals(const glm::dvec3& old, const glm::dvec3& next, double resolution,
                          Precision precision) {
  glm::dvec3 result;
  for (int axis = 0; axis < 3; ++axis) {
    result[axis] = round_to(precision, short_decimal(old[axis], next[axis], resolution));
  }
  return result;
}

}  // namespace

std::vector<Handle> handles_of(const Stage& stage, const ScreenProjection& projection) {
  if (const auto* asked = std::get_if<RayQuestion>(&stage.one.question)) {
    if (!stage.slider || !shows_ray(*stage.slider, asked->ray)) return {};
    return ray_handles(asked->ray, *stage.slider, projection);
  }
  if (const auto* asked = std::get_if<PointAndPolygon<double>>(&stage.one.question)) {
    const glm::dvec3 p(asked->point.x, asked->point.y, 0);
    if (projection.frame.holds(projection.to_pixels(p))) return {{Grip::point, p, 0}};
  }
  return {};
}

glm::dvec3 place_of(const Handle& handle, const Case& one) {
  if (const auto* asked = std::get_if<RayQuestion>(&one.question))
    return asked->ray.origin + handle.t * asked->ray.direction;
  if (const auto* asked = std::get_if<PointAndPolygon<double>>(&one.question))
    return {asked->point.x, asked->point.y, 0};
  return handle.at;
}

Case moved(const Case& one, const Handle& handle, const glm::dvec3& to, double resolution) {
  Case next = one;
  if (auto* asked = std::get_if<RayQuestion>(&next.question)) {
    Ray<double>& ray = asked->ray;
    if (handle.grip == Grip::origin) {
      ray.origin = short_decimals(ray.origin, to, resolution, one.precision);
    } else {
      const glm::dvec3 direction = (to - ray.origin) / handle.t;
      ray.direction =
          short_decimals(ray.direction, direction, resolution / std::abs(handle.t), one.precision);
    }
  } else if (auto* polygon = std::get_if<PointAndPolygon<double>>(&next.question)) {
    const glm::dvec3 old(polygon->point.x, polygon->point.y, 0);
    const glm::dvec3 p = short_decimals(old, to, resolution, one.precision);
    polygon->point = {p.x, p.y};
  }
  return read_case(write_case(next));
}

}  // namespace rayproof::viz
