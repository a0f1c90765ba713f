#include "viz/drawing/topics/quadratic_picture.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "viz/drawing/marks.hpp"
#include "viz/drawing/panels.hpp"
#include "viz/explain/answers.hpp"
#include "viz/trace/numbers.hpp"

namespace rayproof::viz {
namespace {

struct Parabola {
  Quadratic<Shadow> q;
  [[nodiscard]] Shadow at(const Shadow& x) const { return (q.a * x + q.b) * x + q.c; }
  [[nodiscard]] bool has_vertex() const { return q.a != 0; }
  [[nodiscard]] Shadow vertex() const { return -q.b / (2 * q.a); }
};

std::vector<WorldPoint> sample(const Parabola& parabola, const Shadow& left, const Shadow& right) {
  constexpr int count = 240;
  std::vector<WorldPoint> points;
  for (int i = 0; i <= count; ++i) {
    const Shadow x = left + (right - left) * i / count;
    points.push_back({x, parabola.at(x)});
  }
  return points;
}

/// The stretch of the axis, and as much of the curve's height as belongs to it.
View looking_at(const Parabola& parabola, const PixelBox& frame, const Shadow& middle,
                const Shadow& half_width) {
  Shadow top = 0;
  Shadow bottom = 0;
  for (const WorldPoint& p : sample(parabola, middle - half_width, middle + half_width)) {
    top = std::max<Shadow>(top, p.y);
    bottom = std::min<Shadow>(bottom, p.y);
  }
  const Shadow height = top > bottom ? Shadow(top - bottom) : Shadow(1);
  return {frame, {middle, (top + bottom) / 2}, frame.width / 2 / half_width, frame.height * 0.58 / height};
}

View main_view(const Parabola& parabola, const std::vector<NamedMark>& marks, const PixelBox& frame) {
  Shadow left = 0;
  Shadow right = 0;
  const auto include = [&](const Shadow& x) {
    left = std::min<Shadow>(left, x);
    right = std::max<Shadow>(right, x);
  };
  if (parabola.has_vertex()) include(parabola.vertex());
  for (const NamedMark& mark : marks) {
    if (mark.role == Role::exact) include(mark.at.x);
  }
  const bool has_roots =
      std::any_of(marks.begin(), marks.end(), [](const auto& m) { return m.role == Role::exact; });
  if (parabola.has_vertex() && !has_roots) {
    const Shadow opening = sqrt(abs(parabola.at(parabola.vertex()) / parabola.q.a));
    include(parabola.vertex() - opening);
    include(parabola.vertex() + opening);
  }
  const Shadow exact_width = right - left;
  for (const NamedMark& mark : marks) {
    if (mark.role == Role::claimed && (exact_width == 0 || abs(mark.at.x) < 4 * exact_width))
      include(mark.at.x);
  }
  if (left == right) right = left + 1;
  return looking_at(parabola, frame, (left + right) / 2, (right - left) * 0.7);
}

/// Half of the stretch around the vertex in which its height over the axis matters.
Shadow half_opening(const Parabola& parabola, const std::vector<NamedMark>& marks) {
  Shadow half = sqrt(abs(parabola.at(parabola.vertex()) / parabola.q.a));
  for (const NamedMark& mark : marks) half = std::max<Shadow>(half, abs(mark.at.x - parabola.vertex()));
  return half * 1.5;
}

struct ParabolaInset {
  View view;
  std::optional<std::pair<WorldPoint, WorldPoint>> measured;
};

std::optional<ParabolaInset> inset_of(const Parabola& parabola, const View& main, const PixelBox& frame,
                                      const std::vector<NamedMark>& marks, bool verdicts_differ,
                                      const Answer* exact, const Answer* claimed) {
  const auto on_axis = [](double x) { return WorldPoint{x, 0}; };
  if (const auto worst = worst_pair(exact, claimed, on_axis); worst && !verdicts_differ) {
    const Shadow error = abs(worst->first.x - worst->second.x);
    if (error * main.scale_x > visible_gap) return {};
    return ParabolaInset{looking_at(parabola, frame, (worst->first.x + worst->second.x) / 2, error * 1.6),
                         worst};
  }
  if (!parabola.has_vertex()) return {};
  const Shadow half = half_opening(parabola, marks);
  if (half == 0 || half * main.scale_x > 3 * visible_gap) return {};
  return ParabolaInset{looking_at(parabola, frame, parabola.vertex(), half), {}};
}

void draw_scene(Picture& picture, const View& view, const Parabola& parabola,
                const std::vector<NamedMark>& marks, const std::string& caption) {
  draw_frame(picture, view.frame, caption);
  const Shadow left = view.centre.x - view.half_width();
  const Shadow right = view.centre.x + view.half_width();
  draw_curve(picture, view, {Role::ray, {}, 1.5}, {{left, 0}, {right, 0}});
  draw_curve(picture, view, {Role::surface, {}, 2.5}, sample(parabola, left, right));
  draw_marks(picture, view, marks);
  draw_scale_bars(picture, view);
}

std::string equation_of(const Quadratic<double>& q, Precision precision) {
  const auto term = [&](double value) {
    return fmt::format("{} {}", value < 0 ? "−" : "+", shown(std::abs(value), precision));
  };
  return fmt::format("{}·x² {}·x {} = 0", shown(q.a, precision), term(q.b), term(q.c));
}

}  // namespace

Picture quadratic_picture(const Case& one, const Answer* exact, const Answer* claimed) {
  const auto& q = std::get<Quadratic<double>>(one.question);
  const Parabola parabola{convert<Shadow>(q)};
  const auto marks = marks_of("x", exact, claimed, [](double x) { return WorldPoint{x, 0}; });
  Picture picture =
      begin_picture("Quadratic", one, headline_of(one, exact, claimed), equation_of(q, one.precision));
  const Panels panels;
  View main = main_view(parabola, marks, panels.left);
  const auto inset =
      inset_of(parabola, main, panels.right, marks, verdicts_differ(exact, claimed), exact, claimed);
  if (!inset) main = main_view(parabola, marks, panels.whole);
  draw_scene(picture, main, parabola, marks, "The whole curve");
  draw_marks_beyond(picture, main, marks);
  if (inset) {
    draw_focus(picture, main, inset->view);
    draw_scene(picture, inset->view, parabola, marks, magnification(main, inset->view));
    if (inset->measured) {
      const auto& [truth, claim] = *inset->measured;
      draw_measure(picture, inset->view, {truth, claim}, "off by " + rough(abs(truth.x - claim.x), 2));
    }
  }
  finish_picture(picture, panels, "x", one, exact, claimed);
  return picture;
}

}  // namespace rayproof::viz
