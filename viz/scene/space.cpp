#include "viz/scene/space.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <rayproof/box/slabs.hpp>
#include <rayproof/formulas/finite.hpp>

#include "viz/picture/picture.hpp"
#include "viz/scene/items.hpp"

namespace rayproof::viz {
namespace {

/// The part of a segment within reach; nothing where there is none.
SpacePoints within_reach(const glm::dvec3& from, const glm::dvec3& to) {
  const Ray<double> ray{from, to - from};
  const Roots<double> inside = box::Slabs::roots(ray, Box<double>{glm::dvec3(-reach), glm::dvec3(reach)});
  const double first = std::max(0.0, inside.lo);
  const double last = std::min(1.0, inside.hi);
  if (std::isnan(inside.lo) || !(first < last)) return {};
  return {from + first * ray.direction, last == 1 ? to : from + last * ray.direction};
}

/// Of its tube, in the view's radii.
double line_radius(const ShownItem& shown) {
  constexpr double plain = 0.0085;
  if (shown.item->role == Role::frame) return 0.4 * plain;
  if (shown.emphasis == Emphasis::bright) return 1.5 * plain;
  if (shown.emphasis == Emphasis::dimmed) return 0.7 * plain;
  return shown.item->role == Role::ray ? 1.25 * plain : 0.8 * plain;
}

ArrowHead head_of(const glm::dvec3& from, const glm::dvec3& to, double radius) {
  const double length = glm::length(to - from);
  const double head = std::min(9 * radius, 0.5 * length);
  return {to - head / length * (to - from), to, 0.36 * head};
}

/// A line's pieces and head; nothing of one that is out of reach.
std::optional<SpaceBody> line_body(SpaceBody body, bool is_flat) {
  const StageItem& item = *body.shown.item;
  if (body.points.size() < 2) return std::nullopt;
  // What is behind a translucent surface is seen to be: no dashes for it.
  const bool is_on_surface = item.role == Role::surface || item.role == Role::frame;
  const Pattern pattern = is_on_surface && !is_flat ? Pattern::solid : item.pattern;
  SpacePoints line = body.points;
  if (item.form == Form::polyline) {
    const auto is_near = [](const glm::dvec3& p) { return glm::length(p) < reach; };
    if (!std::ranges::all_of(line, is_near)) return std::nullopt;
  } else {
    line = within_reach(body.points[0], body.points[1]);
    if (line.empty()) return std::nullopt;
    if (item.form == Form::arrow && line[1] == body.points[1]) {
      body.head = head_of(line[0], line[1], body.radius);
      line[1] = body.head->base + 0.1 * (body.head->tip - body.head->base);
    }
  }
  body.pieces = pieces_of(line, body.radius, body.head ? Pattern::solid : pattern);
  return body;
}

/// In the plane of the corners, as far as they lie in one.
std::vector<SpacePoints> strips_of(const SpacePoints& ring) {
  if (ring.size() < 4) return {};
  glm::dvec3 normal(0);
  for (const glm::dvec3& p : ring) {
    const glm::dvec3 across = glm::cross(ring[1] - ring[0], p - ring[0]);
    if (glm::length(across) > glm::length(normal)) normal = across;
  }
  if (!(glm::length(normal) > 0)) return {};
  const glm::dvec3 x = glm::normalize(ring[1] - ring[0]);
  const glm::dvec3 y = glm::normalize(glm::cross(normal, x));
  std::vector<Point> flat;
  for (const glm::dvec3& p : ring) flat.push_back({glm::dot(p - ring[0], x), glm::dot(p - ring[0], y)});
  std::vector<SpacePoints> strips;
  for (const Strip& strip : even_odd_strips(flat)) {
    SpacePoints& corners = strips.emplace_back();
    for (const Point& p : strip) corners.push_back(ring[0] + p.x * x + p.y * y);
  }
  return strips;
}

/// Whether there are many polygons, the pieces of a surface, each to be drawn lightly.
bool is_net(const std::vector<ShownItem>& shown) {
  constexpr std::ptrdiff_t many = 12;
  const auto is_polygon = [](const ShownItem& one) { return one.item->form == Form::polygon; };
  return std::ranges::count_if(shown, is_polygon) > many;
}

/// Whether a surface is there to be seen: with coordinates that are numbers, and not a point of the picture.
bool is_seen(const SpacePoints& points) {
  constexpr double speck = 1e-4;
  const auto is_apart = [&](const glm::dvec3& p) { return glm::length(p - points.front()) >= speck; };
  return std::ranges::all_of(points, [](const glm::dvec3& p) { return is_finite(p); }) &&
         std::ranges::any_of(points, is_apart);
}

/// How far a place is from the eye over how far the middle is: what is as much larger looks alike there.
double depth_of(const glm::dvec3& p, const SpaceCamera& camera) {
  if (camera.is_flat) return 1;
  return std::clamp(glm::dot(camera.eye() - p, camera.toward) / camera.distance, 0.2, 3.0);
}

std::optional<SpaceBody> body_of(const ShownItem& shown, const Space& space, bool has_net) {
  const bool is_bright = shown.emphasis == Emphasis::bright;
  const bool is_dimmed = shown.emphasis == Emphasis::dimmed;
  SpaceBody body{shown, placed_points(*shown.item, space.view),  {}, {},
                 {},    line_radius(shown) * space.camera.unit()};
  switch (shown.item->form) {
    case Form::point:
      if (!has_mark(shown.item->role) || !(glm::length(body.points.at(0)) <= reach)) return std::nullopt;
      body.radius =
          (is_bright ? 0.034 : 0.028) * space.camera.unit() * depth_of(body.points[0], space.camera);
      return body;
    case Form::arrow:
    case Form::segment:
    case Form::polyline:
      return line_body(body, space.camera.is_flat);
    case Form::polygon:
    case Form::solid:
    case Form::ellipsoid: {
      if (!is_seen(body.points)) return std::nullopt;
      const bool is_polygon = shown.item->form == Form::polygon;
      if (is_polygon && has_net) body.radius *= 0.5;
      if (shown.item->is_open) body.radius = 0;
      if (is_polygon) body.strips = strips_of(body.points);
      const bool is_thick = is_polygon && (!has_net || space.camera.is_flat);
      body.opacity = is_dimmed ? 0.12 : is_thick ? 0.36 : 0.2;
      return body;
    }
  }
  return std::nullopt;
}

std::optional<SpaceLabel> label_of(const ShownItem& shown, const StageView& view) {
  const StageItem& item = *shown.item;
  if (item.label.empty()) return std::nullopt;
  SpaceLabel label{shown, placed_points(item, view)};
  if (item.form == Form::ellipsoid) {
    label.points.resize(1);
  } else if (item.form == Form::polygon || item.form == Form::solid) {
    glm::dvec3 middle(0);
    for (const glm::dvec3& p : label.points) middle += p / static_cast<double>(label.points.size());
    label.points = {middle};
  } else if (item.form == Form::polyline) {
    label.points = {label.points.back()};
  } else if (item.form != Form::point && label.points.size() > 1) {
    label.points = within_reach(label.points[0], label.points[1]);
    label.is_at_end = item.role == Role::ray;
  }
  if (label.points.empty() || !(glm::length(label.points[0]) <= 2 * reach)) return std::nullopt;
  return label;
}

/// The points of a body that lie lowest, as far as a floor minds.
SpacePoints lowest_points(const SpaceBody& body, const StageCamera& upright) {
  StageItem placed = *body.shown.item;
  placed.points = body.points;
  if (!body.pieces.empty()) placed.points.clear();
  for (const SpacePoints& piece : body.pieces)
    placed.points.insert(placed.points.end(), piece.begin(), piece.end());
  SpacePoints points = extent_of(placed, upright);
  // A line that leaves the picture downward need not stay above the floor.
  constexpr double below_picture = -1.9;
  if (!body.pieces.empty())
    std::erase_if(points, [&](const glm::dvec3& p) { return glm::dot(p, upright.up) < below_picture; });
  for (glm::dvec3& p : points) p -= body.radius * upright.up;
  return points;
}

}  // namespace

SpacePoints placed_points(const StageItem& item, const StageView& view) {
  SpacePoints points;
  for (const glm::dvec3& p : item.points) {
    const glm::dvec3 q = in_view(view, p);
    const bool is_repeated = !points.empty() && q == points.back();  // a tube knows no line of length 0
    if (!is_repeated || item.form == Form::ellipsoid || item.form == Form::solid) points.push_back(q);
  }
  return points;
}

std::vector<SpacePoints> pieces_of(const SpacePoints& line, double radius, Pattern pattern) {
  if (pattern == Pattern::solid) return {line};
  const double dash = (pattern == Pattern::dashed ? 8 : 2) * radius;
  const double pause = 5 * radius;
  std::vector<SpacePoints> pieces;
  double walked = 0;  // since the last dash began
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double length = glm::length(line[i + 1] - line[i]);
    for (double at = 0; at < length;) {
      const bool is_dash = walked < dash;
      const double step = std::min((is_dash ? dash : dash + pause) - walked, length - at);
      if (is_dash) {
        const auto point = [&](double s) { return line[i] + s / length * (line[i + 1] - line[i]); };
        pieces.push_back({point(at), point(at + step)});
      }
      at += step;
      walked += step;
      if (walked >= dash + pause - 1e-12) walked = 0;
    }
  }
  return pieces;
}

Space space_of(const Stage& stage, std::size_t step, double aspect) {
  const std::vector<ShownItem> shown = shown_in(stage, step);
  Space space{stage.steps.at(step).view, space_camera(stage, step, shown, aspect)};
  const bool has_net = is_net(shown);
  for (const ShownItem& one : shown) {
    if (auto body = body_of(one, space, has_net)) space.bodies.push_back(std::move(*body));
    if (auto label = label_of(one, space.view)) space.labels.insert(space.labels.begin(), std::move(*label));
  }
  if (space.camera.is_flat) return space;
  const StageCamera upright{space.camera.up, space.camera.up, space.camera.toward};
  SpacePoints low;
  for (const SpaceBody& body : space.bodies) {
    const SpacePoints own = lowest_points(body, upright);
    low.insert(low.end(), own.begin(), own.end());
  }
  space.floor = floor_below(low, space.camera.up, space.view);
  return space;
}

}  // namespace rayproof::viz
