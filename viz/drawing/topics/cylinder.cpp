#include <rayproof/cylinder/methods.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "viz/drawing/topics/wireframe.hpp"

namespace rayproof::viz {
namespace {

/// In the world, the side is all base + cos φ·x + sin φ·y + s·axis for 0 <= s <= 1.
struct Tube {
  Place base, x, y, axis;
  Place normal_x, normal_y;  ///< cos φ·normal_x + sin φ·normal_y points outward
  Place end_normal;          ///< of the end at axis, outward; unit
  WorldPoint nearest, hit;   ///< cos φ and sin φ where the line passes the axis, and where it hits

  [[nodiscard]] Place spoke(const Shadow& c, const Shadow& s) const { return c * x + s * y; }
  [[nodiscard]] Shadow facing(const Shadow& c, const Shadow& s, const Place& toward) const {
    return dot(c * normal_x + s * normal_y, toward);
  }
};

/// The line's points in the plane scaled by (1/rx, 1/ry), seen from the axis: cos φ and sin φ at t, or of the
/// point nearest the axis.
WorldPoint on_circle(const Sight& sight, const Cylinder<Shadow>& cylinder, const std::optional<Shadow>& at) {
  const Ray<Shadow> ray = sight.world.ray_in_object_space(sight.ray);
  const WorldPoint f{ray.origin.x / cylinder.rx, ray.origin.y / cylinder.ry};
  const WorldPoint d{ray.direction.x / cylinder.rx, ray.direction.y / cylinder.ry};
  const Shadow a = d.x * d.x + d.y * d.y;
  const Shadow nearest = a == 0 ? Shadow(0) : Shadow(-(f.x * d.x + f.y * d.y) / a);
  const Shadow t = at ? *at : nearest;
  const WorldPoint q{f.x + t * d.x, f.y + t * d.y};
  const Shadow r = sqrt(q.x * q.x + q.y * q.y);
  return r == 0 ? WorldPoint{1, 0} : WorldPoint{q.x / r, q.y / r};
}

Tube tube_of(const Sight& sight) {
  const auto cylinder = convert<Shadow>(std::get<Cylinder<double>>(sight.question.shape));
  const World& world = sight.world;
  const Place x = world.vector(Place{cylinder.rx, 0, 0});
  const Place y = world.vector(Place{0, cylinder.ry, 0});
  const Place z = world.vector(Place{0, 0, 1});
  const Place end = unit(cross(x, y));
  const Shadow side = dot(end, z) < 0 ? -1 : 1;
  return {world.point(Place{0, 0, 0}),
          x,
          y,
          cylinder.height * z,
          side * cross(y, z),
          side * cross(z, x),
          side * end,
          on_circle(sight, cylinder, {}),
          on_circle(sight, cylinder, sight.first_t)};
}

/// cos φ and sin φ all around, dense where the line passes nearest and where it hits: by the tangent of half
/// the angle, which is exact without sines.
std::vector<WorldPoint> all_around(const Tube& tube) {
  const WorldPoint& n = tube.nearest;
  const Shadow turn_cos = n.x * tube.hit.x + n.y * tube.hit.y;
  const Shadow turn_sin = n.x * tube.hit.y - n.y * tube.hit.x;
  std::vector<Shadow> half_tangents;
  for (int i = -119; i < 120; ++i) half_tangents.emplace_back(std::tan(std::numbers::pi * i / 240));
  const auto thicken = [&](const Shadow& around) {
    half_tangents.push_back(around);
    for (int i = 20; i < 240; ++i) {  // a quarter of an octave apart
      const Shadow step = std::exp2(-i / 4.0);
      half_tangents.push_back(around - step);
      half_tangents.push_back(around + step);
    }
  };
  thicken(0);
  if (turn_cos > Shadow(-0.999)) thicken(turn_sin / (1 + turn_cos));
  std::sort(half_tangents.begin(), half_tangents.end());
  std::vector<WorldPoint> around;
  for (const Shadow& w : half_tangents) {
    const Shadow c = (1 - w * w) / (1 + w * w);
    const Shadow s = 2 * w / (1 + w * w);
    around.push_back({c * n.x - s * n.y, s * n.x + c * n.y});
  }
  around.push_back(around.front());
  return around;
}

/// A rim in stretches of what is seen and what is hidden. `is_end` for the one at the axis's tip.
void append_rim(std::vector<Stroke>& strokes, const Tube& tube, bool is_end, const Place& toward) {
  const Place middle = is_end ? tube.base + tube.axis : tube.base;
  const bool shows_disk = is_end == (dot(tube.end_normal, toward) > 0);
  bool is_open = false;
  for (const WorldPoint& p : all_around(tube)) {
    const Place place = middle + tube.spoke(p.x, p.y);
    const bool is_hidden = !shows_disk && tube.facing(p.x, p.y, toward) < 0;
    if (is_open && strokes.back().is_hidden != is_hidden) strokes.back().points.push_back(place);
    if (!is_open || strokes.back().is_hidden != is_hidden) strokes.push_back({{}, is_hidden});
    strokes.back().points.push_back(place);
    is_open = true;
  }
}

/// Lines along the side: the two of its outline, and four more for the eye.
void append_sides(std::vector<Stroke>& strokes, const Tube& tube, const Place& toward) {
  const auto add = [&](const Shadow& c, const Shadow& s, bool is_edge) {
    const Place foot = tube.base + tube.spoke(c, s);
    const bool is_hidden = !is_edge && tube.facing(c, s, toward) < 0;
    strokes.push_back({{foot, foot + tube.axis}, is_hidden, is_edge});
  };
  const Shadow a = dot(tube.normal_x, toward);
  const Shadow b = dot(tube.normal_y, toward);
  const Shadow size = sqrt(a * a + b * b);
  if (size > Shadow(1e-40) * (length(tube.normal_x) + length(tube.normal_y))) {
    add(-b / size, a / size, true);
    add(b / size, -a / size, true);
  }
  add(1, 0, false);
  add(0, 1, false);
  add(-1, 0, false);
  add(0, -1, false);
}

/// Of the side or of an end, whichever is nearer by its own measure: the radius, the axis.
Place normal_of(const Tube& tube, const Place& place) {
  const Place p = place - tube.base;
  const Shadow c = dot(p, tube.normal_x) / dot(tube.x, tube.normal_x);
  const Shadow s = dot(p, tube.normal_y) / dot(tube.y, tube.normal_y);
  const Shadow from_side = abs(sqrt(c * c + s * s) - 1);
  const Shadow whole = dot(tube.axis, tube.end_normal);
  const Shadow part = whole == 0 ? Shadow(0) : Shadow(dot(p, tube.end_normal) / whole);
  const bool is_on_side = from_side < std::min<Shadow>(abs(part), abs(part - 1));
  return is_on_side ? unit(c * tube.normal_x + s * tube.normal_y) : tube.end_normal;
}

Figure cylinder_figure(const Sight& sight) {
  const Tube tube = tube_of(sight);
  Figure figure;
  std::vector<Place> rim;
  for (const WorldPoint& p : all_around(tube)) rim.push_back(tube.base + tube.spoke(p.x, p.y));
  figure.extent = rim;
  for (const Place& foot : rim) figure.extent.push_back(foot + tube.axis);
  const Place nearest = tube.base + tube.spoke(tube.nearest.x, tube.nearest.y);
  figure.borders = {rim,
                    {figure.extent.begin() + static_cast<std::ptrdiff_t>(rim.size()), figure.extent.end()},
                    {nearest, nearest + tube.axis}};
  figure.normals = {tube.end_normal, unit(tube.axis + tube.x)};
  figure.labels = {{"z = 0", tube.base}};
  figure.normal_at = [tube](const Place& p) { return normal_of(tube, p); };
  figure.strokes = [tube](const Place& toward) {
    std::vector<Stroke> strokes;
    append_rim(strokes, tube, false, toward);
    append_rim(strokes, tube, true, toward);
    append_sides(strokes, tube, toward);
    return strokes;
  };
  return figure;
}

}  // namespace

TopicView cylinder_view();
TopicView cylinder_view() { return wireframe_view<cylinder::Topic, cylinder_figure>(); }

}  // namespace rayproof::viz
