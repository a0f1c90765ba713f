#include <cmath>
#include <string_view>

#include "case/each_number.hpp"
#include "properties/diagnosis/cures/cures.hpp"

namespace rayproof::diagnosis {
namespace {

/// Calls `act(point)` for every field of a shape that is a point, and not a vector or a length.
template <class S, class Act>
void for_each_point(S& shape, Act&& act) {
  ShapeFormat<S>::fields(shape, [&](std::string_view name, auto& value) {
    using Value = std::remove_reference_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, glm::dvec3>) {
      if (name != "normal" && name != "u" && name != "v") act(value);
    } else if constexpr (std::is_same_v<Value, std::vector<glm::dvec3>>) {
      for (glm::dvec3& point : value) act(point);
    }
  });
}

/// The ray started at another t: the same points, and the same interval of them.
void start_at(Ray<double>& ray, double t) {
  ray.origin += t * ray.direction;
  ray.t_min -= t;
  ray.t_max -= t;
}

struct MiddleOf {
  using Middle = std::optional<glm::dvec3>;
  template <class S>
  Middle operator()(const S& /*a plane*/) const {
    return std::nullopt;
  }
  Middle operator()(const Triangle<double>& t) const { return mean_of({t.a, t.b, t.c}); }
  Middle operator()(const Polygon<double>& polygon) const { return mean_of(polygon.vertices); }
  Middle operator()(const Sphere<double>& sphere) const { return sphere.center; }
  Middle operator()(const Box<double>& box) const { return mean_of({box.min, box.max}); }
  Middle operator()(const Parallelepiped<double>& solid) const {
    return solid.corner + 0.5 * (solid.edges[0] + solid.edges[1] + solid.edges[2]);
  }
  Middle operator()(const Cylinder<double>& cylinder) const { return glm::dvec3(0, 0, cylinder.height / 2); }
};

}  // namespace

glm::dvec3 mean_of(const std::vector<glm::dvec3>& points) {
  glm::dvec3 sum(0);
  for (const glm::dvec3& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

std::optional<glm::dvec3> middle_of(const Shape& shape) { return std::visit(MiddleOf{}, shape); }

std::optional<glm::dvec3> some_point(const Shape& shape) {
  std::optional<glm::dvec3> found;
  Shape copy = shape;
  std::visit(
      [&](auto& s) { for_each_point(s, [&](const glm::dvec3& point) { found = found.value_or(point); }); },
      copy);
  return found;
}

Cases shape_at_zero(const Case& one) {
  return with_question(one, [](RayQuestion& asked) {
    const auto by = some_point(asked.shape);
    if (!by || *by == glm::dvec3(0) || asked.transform) return false;
    std::visit([&](auto& shape) { for_each_point(shape, [&](glm::dvec3& point) { point -= *by; }); },
               asked.shape);
    asked.ray.origin -= *by;
    return true;
  });
}

Cases start_near(const Case& one) {
  return with_question(one, [&](RayQuestion& asked) {
    const RayAnswer line = hits_of_line(one);
    const glm::dvec3 way = some_point(asked.shape).value_or(glm::dvec3(0)) - asked.ray.origin;
    const glm::dvec3& d = asked.ray.direction;
    const double nearest = glm::dot(way, d) / glm::dot(d, d);
    const double t = line.hits.count > 0 ? line.hits.t[0] - 1 / glm::length(d) : nearest;
    if (!std::isfinite(t) || asked.transform) return false;
    start_at(asked.ray, t);
    asked.ray.t_min = std::max(asked.ray.t_min, 0.0);  // nothing is hit before, and many rays have no t < 0
    return asked.ray.t_min <= asked.ray.t_max;
  });
}

Cases start_behind(const Case& one) {
  return with_question(one, [&](RayQuestion& asked) {
    const RayAnswer line = hits_of_line(one);
    if (line.hits.count == 0 || line.hits.t[0] > asked.ray.t_min) return false;
    const double gap = std::abs(line.hits.t[line.hits.count - 1] - line.hits.t[0]);
    start_at(asked.ray, line.hits.t[0] - std::max(gap, 1 / glm::length(asked.ray.direction)));
    asked.ray.t_min = 0;
    return true;
  });
}

Cases plain_interval(const Case& one) {
  return with_question(one, [](RayQuestion& asked) {
    const bool is_plain = asked.ray.t_min == 0 && asked.ray.t_max == infinity<double>;
    asked.ray.t_min = 0;
    asked.ray.t_max = infinity<double>;
    return !is_plain;
  });
}

Cases in_object_space(const Case& one) {
  return with_question(one, [](RayQuestion& asked) {
    if (!asked.transform) return false;
    asked.ray = ray_in_object(asked);
    asked.transform.reset();
    return true;
  });
}

}  // namespace rayproof::diagnosis
