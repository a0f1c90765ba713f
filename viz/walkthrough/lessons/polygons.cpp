#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <rayproof/formulas/polygon_sides.hpp>

#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/compose.hpp"
#include "viz/walkthrough/lesson.hpp"
#include "viz/walkthrough/stage_values.hpp"

namespace rayproof::viz {
namespace {

std::string side_name(std::size_t i, std::size_t count) {
  return fmt::format("v{}v{}", subscript(i), subscript(polygon::next(i, count)));
}

/// One step a side: where the line through it meets the ray's height, by the library's own cross_side.
/// `takes` says whether a side is looked at, given the exact numbers.
template <class R, class Takes>
void cross_sides(const PointAndPolygon<double>& question, Takes&& takes) {
  const Vec2<R> p = named_point<R>("p", question.point);
  std::vector<Vec2<R>> vertices;
  for (std::size_t i = 0; i < question.vertices.size(); ++i) {
    vertices.push_back(named_point<R>("v" + subscript(i), question.vertices[i]));
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const std::size_t next = polygon::next(i, vertices.size());
    step<R>(
        fmt::format("Intersect the side {}", side_name(i, vertices.size())).c_str(),
        "The ray meets the line through the side at t; s is the place on the line, 0 to 1 from end to end.");
    if (!takes(question.vertices[i], question.vertices[next])) continue;
    const auto [s, t] = polygon::cross_side(p, vertices[i], vertices[next]);
    (void)named(("s" + subscript(i)).c_str(), s);
    (void)named(("t" + subscript(i)).c_str(), t);
  }
}

struct PolygonSide {
  glm::dvec3 a, b;
  std::string name;
};

PolygonSide polygon_side(const PointAndPolygon<double>& question, std::size_t i) {
  const std::size_t count = question.vertices.size();
  const auto& a = question.vertices[i];
  const auto& b = question.vertices[polygon::next(i, count)];
  return {{a.x, a.y, 0}, {b.x, b.y, 0}, side_name(i, count)};
}

/// How a lesson counts: which sides it looks at, and which of their crossings.
struct Counting {
  bool (*takes)(const Vec2<double>& point, const Vec2<double>& a, const Vec2<double>& b);
  bool (*counts)(double s, double t);
  bool is_half_open;  ///< a side contains only its lower end
};

/// Of a side that a half-open rule does not look at.
std::string why_not(const PolygonSide& side, const std::string& top, double y, Precision precision) {
  const auto at = [&](double height) { return shown(height, precision); };
  const bool is_level = side.a.y == side.b.y;
  if (is_level && side.a.y == y)
    return fmt::format("{} lies along the ray at y = {} and has no lower end: no crossing.", side.name,
                       at(y));
  const std::string where =
      is_level ? fmt::format("{} lies at y = {}", side.name, at(side.a.y))
               : fmt::format("{} runs from y = {} to {}", side.name, at(side.a.y), at(side.b.y));
  if (std::max(side.a.y, side.b.y) == y)
    return fmt::format(
        "{}. Its upper end {} lies on the ray and is excluded: a side contains only its lower end.", where,
        top);
  return fmt::format("{}, {} the ray at y = {}: no crossing.", where, side.a.y < y ? "below" : "above",
                     at(y));
}

/// A side of the polygon that the ray's line meets, as a lesson speaks of it.
struct CrossedSide {
  PolygonSide side;
  std::string first, second;  ///< the names of its ends
  std::string s, t;           ///< of s and t
  double at, along;           ///< s and t
};

/// What s and t say of a side, by the rule of the lesson.
std::string what_of(const CrossedSide& met, const Counting& counting, double y) {
  const auto& [side, first, second, s, t, at, along] = met;
  if (std::isnan(at))
    return fmt::format("{} is NaN, which fails every ordered comparison: the side counts 0.", s);
  if (!counting.is_half_open && at > 1) return fmt::format("{} > 1, beyond the side: it does not count.", s);
  if (!counting.is_half_open && at < 0) return fmt::format("{} < 0, before the side: it does not count.", s);
  if (!counting.counts(at, along))
    return fmt::format("{} {} 0, {} p: it does not count.", t, along < 0 ? "<" : "=",
                       along < 0 ? "behind" : "at");
  if (!counting.is_half_open) {
    const std::string where = at == 0   ? fmt::format(" It is met at its start {}.", first)
                              : at == 1 ? fmt::format(" It is met at its end {}.", second)
                                        : "";
    return fmt::format("0 ≤ {} ≤ 1 and {} > 0: it counts.{}", s, t, where);
  }
  if (std::min(side.a.y, side.b.y) == y)
    return fmt::format("{} is its lower end and lies on the ray: included. {} > 0: it counts.",
                       side.a.y < side.b.y ? first : second, t);
  return fmt::format("One end lies below the ray and one above, and {} > 0: it counts.", t);
}

/// The last `many` of `count` crossings, which lie at one place.
std::string names_of(int many, int count) {
  return many == 1 ? fmt::format("crossing {}", count)
                   : fmt::format("crossings {} {} {}", count + 1 - many, many == 2 ? "and" : "to", count);
}

Stage counted_stage(const CaseReport& report, const Counting& counting) {
  const auto& question = std::get<PointAndPolygon<double>>(report.one.question);
  const Walkthrough walk = record(report.one.precision, [&]<class R>(std::type_identity<R>) {
    cross_sides<R>(question,
                   [&](const auto& a, const auto& b) { return counting.takes(question.point, a, b); });
  });
  const Setting setting = setting_of(report);
  Stage stage = composed_stage(report, walk, setting);
  int count = 0;
  int at_one_place = 0;  // of the crossings counted last
  double place = 0;
  const glm::dvec3 p(question.point.x, question.point.y, 0);
  for (std::size_t i = 0; i < question.vertices.size(); ++i) {
    StageStep& step = stage.steps[i + 1];
    const PolygonSide side = polygon_side(question, i);
    const std::size_t after = polygon::next(i, question.vertices.size());
    step.items.push_back(segment(Role::edge, side.a, side.b));
    if (step.values.empty()) {
      const std::size_t top = side.a.y > side.b.y ? i : after;
      step.caption = fmt::format("{} Crossings so far: {}.",
                                 why_not(side, "v" + subscript(top), p.y, report.one.precision), count);
      if (side.a.y != side.b.y && std::max(side.a.y, side.b.y) == p.y)
        step.items.push_back(point(Role::muted, side.a.y > side.b.y ? side.a : side.b, "excluded"));
      continue;
    }
    const WalkValue& s = step.values[0].components[0];
    const WalkValue& t = step.values[1].components[0];
    const bool is_counted = counting.counts(s.value, t.value);
    count += is_counted ? 1 : 0;
    if (std::isfinite(t.value)) {
      if (is_counted) {
        at_one_place = t.value == place ? at_one_place + 1 : 1;
        place = t.value;
      }
      step.items.push_back(point(is_counted ? Role::claimed : Role::muted, p + glm::dvec3(t.value, 0, 0),
                                 is_counted ? names_of(at_one_place, count) : "not counted"));
      step.items.back().stands_for_earlier = is_counted;
    }
    const CrossedSide met{
        side,   "v" + subscript(i), "v" + subscript(after), step.values[0].name, step.values[1].name, s.value,
        t.value};
    step.words = fmt::format("{} Crossings so far: {}.", what_of(met, counting, p.y), count);
    step.caption = fmt::format("{} {}, {}.", step.words, equation_of(step.values[0], report.one.precision),
                               equation_of(step.values[1], report.one.precision));
  }
  StageStep last{.title = comparison_title, .view = setting.near};
  last.caption = fmt::format(
      "{} {} {}: the point is {}. In exact arithmetic it is {}.", count,
      count == 1 ? "crossing is" : "crossings are", count % 2 == 1 ? "an odd number" : "an even number",
      count % 2 == 1 ? "inside" : "outside", name_of(std::get<Position>(report.exact)));
  last.items.push_back(
      point(Role::exact, p, std::string("exact: ") + name_of(std::get<Position>(report.exact))));
  last.items.push_back(point(Role::claimed, p, count % 2 == 1 ? "computed: inside" : "computed: outside"));
  stage.steps.push_back(last);
  stage.conclusion = last.caption;
  return stage;
}

bool has_ends_apart(const Vec2<double>& p, const Vec2<double>& a, const Vec2<double>& b) {
  return polygon::passes(p.y, a, b);
}
bool any_side(const Vec2<double>& /*p*/, const Vec2<double>& /*a*/, const Vec2<double>& /*b*/) {
  return true;
}

}  // namespace

Stage parity_stage(const Case& one, const ReportCase& report_on) {
  return counted_stage(report_on(one, "point_in_polygon/parity"),
                       {has_ends_apart, [](double /*s*/, double t) { return t > 0; }, true});
}

/// As the lecture prints it: a side is met for s in [0, 1], closed at both ends.
Stage printed_stage(const Case& one, const ReportCase& report_on) {
  return counted_stage(report_on(one, "point_in_polygon/printed_parity"),
                       {any_side, [](double s, double t) { return s >= 0 && s <= 1 && t > 0; }, false});
}

}  // namespace rayproof::viz
