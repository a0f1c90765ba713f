#include <fmt/format.h>

#include <array>
#include <rayproof/formulas/polygon_sides.hpp>
#include <rayproof/ray.hpp>

#include "viz/scene/items.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/bindings.hpp"
#include "viz/walkthrough/compose.hpp"
#include "viz/walkthrough/lesson.hpp"

namespace rayproof::viz {
namespace {

template <class R>
void walk_along(const Ray<double>& given) {
  const Ray<R> ray = named_ray<R>(given);
  step<R>("At t = 0 there is the origin", "p(0) = o + 0·d: the ray begins there.");
  (void)named("p(0)", point_at(ray, R(0)));
  step<R>("At t = 1 the ray is at the tip of d", "p(1) is the tip of d, drawn from the origin.");
  (void)named("p(1)", point_at(ray, R(1)));
  step<R>("At t = 2.5 it has gone two and a half times d", "t is any number, not only a whole one.");
  (void)named("p(2.5)", point_at(ray, R(2.5)));
  step<R>("At t = -0.5 the line has not reached the origin",
          "A ray has no t below t_min = 0: p(-0.5) is a point of the line, not of the ray.");
  (void)named("p(-0.5)", point_at(ray, R(-0.5)));
  step<R>("t counts lengths of d: the distance is t·|d|",
          "Only for a direction of length 1 are t and the distance the same number.");
  const R length = named("|d|", sqrt(dot(ray.direction, ray.direction)));
  (void)named("distance", R(2.5) * length);
}

/// A ray along +x at one segment, by the library's own cross_side.
struct Try {
  const char* title;
  const char* words;
  Vec2<double> origin;
  const char* s;
  const char* t;
};
constexpr std::array<Try, 3> tries{
    {{"A ray that meets the segment", "0 ≤ s₀ ≤ 1 and t₀ > 0: a hit.", {-1.1, 0.3}, "s₀", "t₀"},
     {"A ray that passes beyond its end",
      "s₁ > 1: the line of the segment is met beyond v₁.",
      {-1.1, 1.2},
      "s₁",
      "t₁"},
     {"A ray that begins beyond it",
      "t₂ < 0: the segment lies behind the ray's origin.",
      {1.6, 0.1},
      "s₂",
      "t₂"}}};

template <class R>
void try_rays(const Vec2<double>& first, const Vec2<double>& second) {
  const Vec2<R> v0 = named_point<R>("v₀", first);
  const Vec2<R> v1 = named_point<R>("v₁", second);
  for (const Try& one : tries) {
    step<R>(Step(one.title, "s is the place on the segment, 0 at v₀ and 1 at v₁; t is that on the ray."));
    const auto [s, t] = polygon::cross_side(named_point<R>("p", one.origin), v0, v1);
    (void)named(one.s, s);
    (void)named(one.t, t);
  }
}

}  // namespace

Stage ray_stage(const Case& one, const ReportCase& report_on) {
  const CaseReport report = report_on(one, "");
  const auto& ray = std::get<RayQuestion>(one.question).ray;
  const Walkthrough walk = record(one.precision, [&]<class R>(std::type_identity<R>) { walk_along<R>(ray); });
  Setting setting = setting_of(report);
  // The sphere is the case's, not the lesson's.
  std::erase_if(setting.scene, [](const StageItem& item) { return item.role != Role::ray; });
  setting.near = setting.wide;
  setting.slider->from = setting.slider->start = ray.t_min;  // where the first step begins
  setting.bindings = {
      marked("p(0)", Role::nearest),
      marked("p(1)", Role::nearest),
      marked("p(2.5)", Role::nearest),
      {"p(-0.5)",
       [](const NumbersByName& n) {
         return Items{point(Role::nearest, n.vector("p(-0.5)"), "p(-0.5)"),
                      segment(Role::frame, n.vector("p(-0.5)"), n.origin(), {}, Pattern::dotted)};
       }},
      {"p(1)",
       [](const NumbersByName& n) { return Items{arrow(Role::edge, n.origin(), n.vector("p(1)"), "d")}; }},
      {"distance", [](const NumbersByName& n) {
         return Items{segment(Role::edge, n.origin(), n.vector("p(2.5)"), "2.5·|d|")};
       }}};
  return run_stage(report, walk, setting);
}

Stage segment_stage(const Case& one, const ReportCase& report_on) {
  const CaseReport report = report_on(one, "");
  const auto& ends = std::get<PointAndPolygon<double>>(one.question).vertices;
  const Walkthrough walk =
      record(one.precision, [&]<class R>(std::type_identity<R>) { try_rays<R>(ends.at(0), ends.at(1)); });
  const glm::dvec3 v0(ends[0].x, ends[0].y, 0), v1(ends[1].x, ends[1].y, 0);
  Setting setting = plot_setting();
  setting.scene = {segment(Role::surface, v0, v1),
                   segment(Role::frame, v1, v0 + 1.6 * (v1 - v0), {}, Pattern::dashed),
                   point(Role::surface, v0, "v₀: s = 0"), point(Role::surface, v1, "v₁: s = 1")};
  setting.near = setting.wide = {{0.3, 0.2, 0}, 1.3};
  Stage stage = run_stage(report, walk, setting);
  for (std::size_t i = 0; i < tries.size(); ++i) {
    StageStep& step = stage.steps.at(i + 1);
    const Try& tried = tries.at(i);
    const NumbersByName n(walk, i);
    const glm::dvec3 p(tried.origin.x, tried.origin.y, 0);
    const glm::dvec3 met = p + glm::dvec3(n[tried.t], 0, 0);
    step.begins_anew = true;
    step.caption.insert(0, std::string(tried.words) + " ");
    step.words.insert(0, std::string(tried.words) + " ");
    step.items = {
        arrow(Role::ray, p, glm::dvec3(2.2, p.y, 0), "+x"), point(Role::ray, p, "p"),
        point(i == 0 ? Role::claimed : Role::nearest, met,
              fmt::format("{} = {}, {} = {}", tried.s, rough(n[tried.s], 3), tried.t, rough(n[tried.t], 3)))};
    if (n[tried.t] < 0) step.items.push_back(segment(Role::frame, met, p, {}, Pattern::dotted));
  }
  return stage;
}

}  // namespace rayproof::viz
