#include <fmt/format.h>

#include <array>
#include <rayproof/formulas/polygon_sides.hpp>

#include "viz/scene/items.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/compose.hpp"
#include "viz/walkthrough/lesson.hpp"

namespace rayproof::viz {
namespace {

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

Stage segment_stage(const Case& one, const ReportCase& report_on) {
  const CaseReport report = report_on(one, "");
  const auto& ends = std::get<PointAndPolygon<double>>(one.question).vertices;
  const Walkthrough walk =
      record(one.precision, [&]<class R>(std::type_identity<R>) { try_rays<R>(ends.at(0), ends.at(1)); });
  const glm::dvec3 v0(ends[0].x, ends[0].y, 0), v1(ends[1].x, ends[1].y, 0);
  Setting setting = plot_setting(report);
  setting.slider.reset();
  setting.scene = {segment(Role::surface, v0, v1),
                   segment(Role::frame, v1, v0 + 1.6 * (v1 - v0), {}, Pattern::dashed),
                   point(Role::surface, v0, "v₀: s = 0"), point(Role::surface, v1, "v₁: s = 1")};
  setting.bindings.clear();
  setting.near = setting.wide = {{0.3, 0.2, 0}, 1.3};
  Stage stage = composed_stage(report, walk, setting);
  stage.steps.front().title = "Look at the segment";
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
  stage.steps.push_back(difference_of_values(walk, setting, one.precision));
  stage.method = "polygon::cross_side";
  stage.conclusion = "A segment is hit where s lies in [0, 1] and t is more than 0.";
  return stage;
}

}  // namespace rayproof::viz
