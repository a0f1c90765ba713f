#include "oracle/leaving/leaving.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <stdexcept>

#include "oracle/leaving/equation.hpp"
#include "oracle/shapes/shapes.hpp"

namespace rayproof::oracle {

namespace {

enum class Asked { value, slope };

/// The sign that a ring is certain of, or nothing.
template <class R>
std::optional<int> sign_in(const RayQuestion& question, const SurfacePiece& piece, Asked asked) {
  const ObjectRay<R> ray(question);
  const auto value = [&]<class S>(const S& shape) -> PieceValue<R> {
    if constexpr (has_pieces<S>)
      return value_at(ray, shape, piece);
    else
      throw std::logic_error("the judge knows no pieces of this shape");
  };
  const PieceValue<R> at = std::visit(value, question.shape);
  const auto found = certain_sign(asked == Asked::value ? at.value : at.slope);
  if (!found || !at.is_odd || !question.transform) return found;
  const auto scale = certain_sign(ray.scale);
  return scale ? std::optional(*found * *scale) : std::nullopt;
}

/// Whether doubles can neither overflow nor underflow in the filters' formulas.
bool is_in_reach(const RayQuestion& question) {
  const auto is_small = [](double x) { return x == 0 || (std::abs(x) > 0x1p-60 && std::abs(x) < 0x1p+60); };
  bool all = true;
  const auto look = [&](double x) { all = all && is_small(x); };
  each_number(question.ray.origin, look);
  each_number(question.ray.direction, look);
  std::visit([&](const auto& shape) { each_number(shape, look); }, question.shape);
  if (question.transform) each_number(*question.transform, look);
  return all;
}

int exact_sign(const RayQuestion& question, const SurfacePiece& piece, Asked asked) {
  if (is_in_reach(question)) {
    if (const auto found = sign_in<Interval>(question, piece, asked)) return *found;
    if (const auto found = sign_in<Estimate>(question, piece, asked)) return *found;
  }
  return *sign_in<Ring>(question, piece, asked);
}

bool has_hits(const RayQuestion& question) {
  return std::visit([&](const auto& shape) { return !intersection_of(question, shape)->hits().empty(); },
                    question.shape);
}

/// The pieces that bound a solid, or that are met at all from inside a tube.
std::vector<SurfacePiece> pieces_of(const Shape& shape) {
  const auto faces = [] {
    std::vector<SurfacePiece> all;
    for (int i = 0; i < 6; ++i) all.push_back({i / 2, i % 2 == 1});
    return all;
  };
  if (std::holds_alternative<Box<double>>(shape) || std::holds_alternative<Parallelepiped<double>>(shape))
    return faces();
  if (const auto* cylinder = std::get_if<Cylinder<double>>(&shape); cylinder != nullptr && cylinder->capped)
    return {{0, false}, {1, false}, {1, true}};
  return {{}};
}

double length(const glm::dvec3& v) { return std::sqrt(dot(v, v)); }

}  // namespace

bool has_inside(const Shape& shape) {
  return std::holds_alternative<Sphere<double>>(shape) || std::holds_alternative<Box<double>>(shape) ||
         std::holds_alternative<Parallelepiped<double>>(shape) ||
         std::holds_alternative<Cylinder<double>>(shape);
}

SurfacePiece piece_of(const Shape& shape, const glm::dvec3& normal) {
  if (std::holds_alternative<Cylinder<double>>(shape))
    return std::abs(normal.z) > 0.5 ? SurfacePiece{1, normal.z > 0} : SurfacePiece{};
  const auto* solid = std::get_if<Parallelepiped<double>>(&shape);
  if (solid == nullptr && !std::holds_alternative<Box<double>>(shape)) return {};
  SurfacePiece nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const SurfacePiece& face : pieces_of(shape)) {
    glm::dvec3 outward(0);
    outward[face.index] = 1;
    if (solid != nullptr) {
      const auto edge = [&](int i) { return solid->edges.at(static_cast<std::size_t>(i % 3)); };
      outward = glm::cross(edge(face.index + 1), edge(face.index + 2));
      outward *= (dot(outward, edge(face.index)) < 0 ? -1 : 1) / length(outward);
    }
    const double apart = length(normal / length(normal) - (face.is_upper ? outward : -outward));
    if (!(apart < least)) continue;
    least = apart;
    nearest = face;
  }
  return nearest;
}

int climb(const RayQuestion& ray, const SurfacePiece& piece) { return exact_sign(ray, piece, Asked::slope); }

Departure depart(const RayQuestion& ray, const SurfacePiece& piece, spawn::Side side) {
  const glm::dvec3& origin = ray.ray.origin;
  if (!std::isfinite(origin.x) || !std::isfinite(origin.y) || !std::isfinite(origin.z))
    return Departure::no_origin;
  const bool is_inward = side == spawn::Side::back && has_inside(ray.shape);
  if (is_inward) {
    const auto is_inside = [&](const SurfacePiece& one) { return exact_sign(ray, one, Asked::value) < 0; };
    if (std::ranges::all_of(pieces_of(ray.shape), is_inside)) return Departure::clear;
    return has_hits(ray) ? Departure::false_hit : Departure::skipped;
  }
  const int outward = side == spawn::Side::front ? 1 : -1;
  const bool is_beyond = exact_sign(ray, piece, Asked::value) * outward > 0;
  if (is_beyond && climb(ray, piece) * outward >= 0) return Departure::clear;
  return has_hits(ray) ? Departure::false_hit : Departure::clear;
}

namespace {

SceneExtent own_extent(const Sphere<double>& s) { return {length(s.center) + s.radius, 2 * s.radius}; }
SceneExtent own_extent(const Box<double>& box) {
  const glm::dvec3 widths = box.max - box.min;
  return {std::max(length(box.min), length(box.max)), std::min({widths.x, widths.y, widths.z})};
}
SceneExtent own_extent(const Parallelepiped<double>& p) {
  double width = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 normal = glm::cross(p.edges.at((i + 1) % 3), p.edges.at((i + 2) % 3));
    width = std::min(width, std::abs(dot(normal, p.edges.at(i))) / length(normal));
  }
  return {length(p.corner) + length(p.edges[0]) + length(p.edges[1]) + length(p.edges[2]), width};
}
SceneExtent own_extent(const Cylinder<double>& c) {
  return {std::max({c.rx, c.ry, c.height}), std::min({2 * c.rx, 2 * c.ry, c.capped ? c.height : HUGE_VAL})};
}
SceneExtent own_extent(const Triangle<double>& t) {
  return {std::max({length(t.a), length(t.b), length(t.c)}), HUGE_VAL};
}
SceneExtent own_extent(const Polygon<double>& polygon) {
  double size = 0;
  for (const glm::dvec3& v : polygon.vertices) size = std::max(size, length(v));
  return {size, HUGE_VAL};
}
SceneExtent own_extent(const auto& /*plane*/) { return {0, HUGE_VAL}; }

}  // namespace

SceneExtent extent_of(const RayQuestion& question, const glm::dvec3& point) {
  SceneExtent extent = std::visit([](const auto& shape) { return own_extent(shape); }, question.shape);
  if (question.transform) {
    const glm::dmat3 linear(*question.transform), back = glm::inverse(linear);
    const auto norm = [](const glm::dmat3& m) {
      return std::sqrt(dot(m[0], m[0]) + dot(m[1], m[1]) + dot(m[2], m[2]));
    };
    if (extent.size > 0)
      extent.size = norm(linear) * extent.size + length(glm::dvec3((*question.transform)[3]));
    extent.width /= norm(back);
  }
  if (extent.size == 0)
    extent.size = length(question.ray.origin);  // a plane is as large as what is seen of it
  extent.size = std::max({extent.size, std::abs(point.x), std::abs(point.y), std::abs(point.z)});
  return extent;
}

}  // namespace rayproof::oracle
