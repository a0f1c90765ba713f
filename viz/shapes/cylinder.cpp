#include <cmath>
#include <numbers>
#include <rayproof/cylinder/methods.hpp>

#include "viz/shapes/topics.hpp"

namespace rayproof::viz {
namespace {

/// cos φ and sin φ.
struct RimAngle {
  Shadow c = 1;
  Shadow s = 0;

  [[nodiscard]] static RimAngle by(double angle) {
    return RimAngle{std::cos(angle), std::sin(angle)}.turned(0);
  }
  /// By a small angle more; exactly on the circle.
  [[nodiscard]] RimAngle turned(const Shadow& step) const {
    const Shadow x = c - step * s;
    const Shadow y = s + step * c;
    const Shadow size = sqrt(x * x + y * y);
    return {x / size, y / size};
  }
};

/// In the world, the side is all base + cos φ·x + sin φ·y + s·axis for 0 <= s <= 1.
struct Tube {
  Place base, x, y, axis;

  [[nodiscard]] Place spoke(const RimAngle& turn) const { return turn.c * x + turn.s * y; }
};

Tube tube_of(const Sight& sight, const Cylinder<Shadow>& cylinder) {
  const World& world = sight.world;
  return {world.point(Place{0, 0, 0}), world.vector(Place{cylinder.rx, 0, 0}),
          world.vector(Place{0, cylinder.ry, 0}), world.vector(Place{0, 0, cylinder.height})};
}

/// The spoke toward the line's point nearest the axis, in the plane scaled by (1/rx, 1/ry).
Place nearest_spoke(const Sight& sight, const Cylinder<Shadow>& cylinder, const Tube& tube) {
  const Ray<Shadow> ray = sight.world.ray_in_object_space(sight.ray);
  const Place f{ray.origin.x / cylinder.rx, ray.origin.y / cylinder.ry, 0};
  const Place d{ray.direction.x / cylinder.rx, ray.direction.y / cylinder.ry, 0};
  const Shadow a = dot(d, d);
  const Place offset = a == 0 ? f : f - dot(f, d) / a * d;
  if (length(offset) > ldexp(length(f), -200)) {
    const Place q = unit(offset);
    return tube.spoke({q.x, q.y});
  }
  // Through the axis: across the ray, or anywhere where it runs along the axis.
  const Place across = unit(Place{-d.y, d.x, 0});
  return a == 0 ? tube.x : tube.spoke({across.x, across.y});
}

/// A short line on a rim at its point nearest the ray's line.
Border rim_border(const Sight& sight, const Tube& tube, const Place& middle, const Place& inward) {
  const Place along = unit(sight.ray.direction);
  const auto square_gap = [&](const RimAngle& turn) {
    const Place off = middle + tube.spoke(turn) - sight.ray.origin;
    const Place across = off - dot(off, along) * along;
    return dot(across, across);
  };
  constexpr int count = 48;
  RimAngle best;
  Shadow least = square_gap(best);
  const auto look_at = [&](const RimAngle& turn) {
    const Shadow gap = square_gap(turn);
    if (!(gap < least)) return;
    least = gap;
    best = turn;
  };
  for (int i = 1; i < count; ++i) look_at(RimAngle::by(2 * std::numbers::pi * i / count));
  for (Shadow step = 0x1p-3; step > Shadow(0x1p-120); step /= 2) {
    look_at(best.turned(step));
    look_at(best.turned(-step));
  }
  const Place spoke = tube.spoke(best);
  const Place tangent = Shadow(0x1p-7) * tube.spoke({-best.s, best.c});
  return {{middle + spoke - tangent, middle + spoke + tangent}, {unit(Shadow(-1) * spoke), unit(inward)}};
}

/// The faces around it, then both ends.
void add_faces(Figure& figure, const Tube& tube) {
  constexpr std::size_t count = 48;
  std::vector<std::size_t> foot, head;
  for (std::size_t i = 0; i < count; ++i) {
    const Place rim =
        tube.base + tube.spoke(RimAngle::by(2 * std::numbers::pi * static_cast<double>(i) / count));
    figure.points.push_back(rim);
    figure.points.push_back(rim + tube.axis);
    foot.push_back(2 * i);
    head.push_back(2 * i + 1);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    figure.faces.push_back({foot[i], foot[next], head[next], head[i]});
  }
  figure.faces.push_back(foot);
  figure.faces.push_back(head);
}

}  // namespace

Figure figure_of(const Sight& sight, const Cylinder<double>& given) {
  const auto cylinder = convert<Shadow>(given);
  const Tube tube = tube_of(sight, cylinder);
  const Place side = tube.base + nearest_spoke(sight, cylinder, tube);
  Figure figure;
  add_faces(figure, tube);
  figure.borders = {{{side, side + tube.axis}},
                    rim_border(sight, tube, tube.base, tube.axis),
                    rim_border(sight, tube, tube.base + tube.axis, Shadow(-1) * tube.axis)};
  figure.normals = {unit(cross(tube.x, tube.y)), unit(tube.axis + tube.x)};
  if (dot(figure.normals[0], tube.axis) < 0) figure.normals[0] = Shadow(-1) * figure.normals[0];
  for (std::size_t i = 0; i < figure.points.size(); i += 24)
    figure.grid.push_back({figure.points[i], figure.points[i + 1]});
  figure.labels = {{"z = 0", tube.base}};
  return figure;
}

}  // namespace rayproof::viz
