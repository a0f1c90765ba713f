#include "viz/drawing/topics/point_in_polygon_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <rayproof/formulas/polygon_sides.hpp>

#include "viz/drawing/even_odd.hpp"
#include "viz/drawing/panels.hpp"
#include "viz/drawing/topics/fit.hpp"
#include "viz/explain/answers.hpp"
#include "viz/trace/numbers.hpp"

namespace rayproof::viz {
namespace {

/// The polygon as the point sees it: the point is at (0, 0), its ray runs along y = 0.
struct PlanView {
  std::vector<WorldPoint> ring;
  std::vector<Shadow> crossings;  ///< x where the ray crosses a side, ascending
  WorldPoint nearest;             ///< the boundary's point nearest to the point
  Shadow gap;
};

PlanView plan_of(const PointAndPolygon<Shadow>& question) {
  PlanView plan;
  const Vec2<Shadow>& p = question.point;
  for (const auto& v : question.vertices) plan.ring.push_back({v.x - p.x, v.y - p.y});
  bool is_first = true;
  polygon::for_each_side(question.vertices, [&](const Vec2<Shadow>& a, const Vec2<Shadow>& b) {
    if (polygon::passes(p.y, a, b)) {
      const Shadow t = polygon::cross_side(p, a, b).t;
      if (t > 0) plan.crossings.push_back(t);
    }
    const Vec2<Shadow> side{b.x - a.x, b.y - a.y};
    const Shadow square = side.x * side.x + side.y * side.y;
    const Shadow along = (p.x - a.x) * side.x + (p.y - a.y) * side.y;
    const Shadow part = square == 0 ? Shadow(0) : std::clamp<Shadow>(along / square, 0, 1);
    const WorldPoint at{a.x - p.x + part * side.x, a.y - p.y + part * side.y};
    const Shadow gap = sqrt(at.x * at.x + at.y * at.y);
    if (is_first || gap < plan.gap) {
      plan.nearest = at;
      plan.gap = gap;
    }
    is_first = false;
  });
  std::sort(plan.crossings.begin(), plan.crossings.end());
  return plan;
}

void draw_crossings(Picture& picture, const View& view, const PlanView& plan) {
  double last = -1e9;
  for (std::size_t i = 0; i < plan.crossings.size(); ++i) {
    const WorldPoint at{plan.crossings[i], 0};
    draw_mark(picture, view, Role::nearest, MarkShape::diamond, at);
    const Point pixel = view.to_pixels(at);
    if (!view.shows(at) || pixel.x - last < 18 || pixel.y < view.frame.top + 24) continue;
    last = pixel.x;
    const double x = std::min(pixel.x, view.frame.right() - 12);
    picture.elements.emplace_back(
        Text{Role::nearest, {x, pixel.y - 12}, std::to_string(i + 1), Anchor::middle, 14, true, true});
  }
}

void draw_panel(Picture& picture, const View& view, const PlanView& plan, const std::string& caption) {
  draw_frame(picture, view.frame, caption);
  draw_even_odd(picture, view, Role::surface, plan.ring);
  std::vector<WorldPoint> outline = plan.ring;
  outline.push_back(outline.front());
  draw_curve(picture, view, {Role::surface, {}, 2}, outline);
  draw_ray_line(picture, view, {Shadow(0), {}});
  draw_crossings(picture, view, plan);
  draw_scale_bars(picture, view);
}

std::string geometry_of(const PlanView& plan) {
  const std::size_t count = plan.crossings.size();
  return fmt::format(
      "The ray to the right crosses {} side{} (lower ends count, upper ones don't); the boundary is {}.",
      count, count == 1 ? "" : "s", plan.gap == 0 ? "here" : rough(plan.gap, 3) + " off");
}

}  // namespace

Picture point_in_polygon_picture(const Case& one, const Answer* exact, const Answer* claimed) {
  const PlanView plan = plan_of(convert<Shadow>(std::get<PointAndPolygon<double>>(one.question)));
  Picture picture =
      begin_picture("Point and polygon", one, headline_of(one, exact, claimed), geometry_of(plan));
  const Panels panels;
  const Extent extent = Extent::of(plan.ring);
  const RayLine ray{Shadow(0), {}};
  Fitted main = fit(panels.left, extent, ray, {});
  const bool hides_gap = plan.gap > 0 && plan.gap * main.view.scale_x < 8;
  if (!hides_gap) main = fit(panels.whole, extent, ray, {});
  draw_panel(picture, main.view, plan,
             main.leaves_ray_out ? "The polygon alone, to scale; the point lies too far off to be shown"
                                 : "To scale");
  if (!main.leaves_ray_out) draw_start_beyond(picture, main.view, ray, abs(main.view.centre.x));
  if (hides_gap) {
    const View view = View::around(panels.right, {plan.nearest.x / 2, plan.nearest.y / 2}, plan.gap * 2,
                                   plan.gap * Shadow(1.5));
    draw_focus(picture, main.view, view);
    draw_panel(picture, view, plan, magnification(main.view, view));
    draw_measure(picture, view, {{0, 0}, plan.nearest}, rough(plan.gap, 2) + " between");
  }
  finish_picture(picture, panels, "", one, exact, claimed);
  return picture;
}

}  // namespace rayproof::viz
