#include <rayproof/ray.hpp>

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
  Stage stage = composed_stage(report, walk, setting);
  stage.steps.front().title = "Look at the ray";
  stage.method = "p(t) = o + t·d";
  stage.steps.push_back(difference_of_values(walk, setting, one.precision));
  stage.conclusion = "A point of the ray is rounded twice in each coordinate, by the product and by the sum.";
  return stage;
}

}  // namespace rayproof::viz
