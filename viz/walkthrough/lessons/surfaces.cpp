#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <rayproof/implicit/roots.hpp>
#include <rayproof/implicit/torus.hpp>
#include <rayproof/parametric/bilinear_quadratic.hpp>

#include "viz/scene/fit_view.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/bindings.hpp"
#include "viz/walkthrough/compose.hpp"
#include "viz/walkthrough/lessons.hpp"

namespace rayproof::viz {
namespace {

constexpr implicit::Torus<double> torus{1.25, 0.5};

Items torus_items() {
  constexpr int around = 16, over = 6;  // more would make the page too large
  constexpr double turn = 6.283185307179586;
  const auto at = [](int i, int j) {
    const double r = torus.major + torus.minor * std::cos(turn * j / over);
    const double angle = turn * i / around;
    return glm::dvec3(r * std::cos(angle), r * std::sin(angle), torus.minor * std::sin(turn * j / over));
  };
  Items items;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < over; ++j)
      items.push_back(polygon(Role::surface, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}));
  }
  return items;
}

template <class R>
void close_in(const Ray<double>& given, double before, double behind) {
  Ray<R> ray = convert<R>(given);
  ray.origin = named("o", ray.origin);
  ray.direction = named("d", ray.direction);
  const implicit::Torus<double>& f = torus;
  const auto value = [&](const char* point, const char* name, double t) {
    step<R>(
        Step(name, "f at a point of the ray: its sign says on which side of the surface the point lies."));
    const vec3<R> p = named(point, point_at(ray, R(t)));
    return f(p.x, p.y, p.z, R(1));
  };
  const R first = named("f(t_a)", value("p_a", "Take a point outside: f > 0", before));
  const R second = named("f(t_b)", value("p_b", "Take a point inside: f < 0", behind));
  step<R>(
      "Guess where f changes its sign",
      "f is continuous, so between both there is a root: t_s is where the straight line between them is 0.");
  const R share = named("share", first / (first - second));
  (void)named("t_s", R(before) + share * R(behind - before));
}

Setting surface_setting(const CaseReport& report, Items surface, double reach) {
  Setting setting = setting_of(report);
  const Ray<double>& ray = std::get<RayQuestion>(report.one.question).ray;
  setting.scene = std::move(surface);
  setting.scene.push_back(arrow(Role::ray, ray.origin, ray.origin + reach * ray.direction, "p(t)"));
  setting.scene.push_back(point(Role::ray, ray.origin, "o"));
  setting.near = setting.wide = view_of(extent_of(setting.scene, setting.camera), setting.camera);
  setting.spaces.clear();
  setting.slider->from = 0;
  setting.slider->to = reach;
  setting.slider->readouts.clear();
  return setting;
}

}  // namespace

Stage torus_stage(const Case& one, const ReportCase& report_on) {
  const CaseReport report = report_on(one, "");
  const Ray<double>& ray = std::get<RayQuestion>(one.question).ray;
  constexpr double before = 1, behind = 1.5;
  const Walkthrough walk =
      record(one.precision, [&]<class R>(std::type_identity<R>) { close_in<R>(ray, before, behind); });
  Setting setting = surface_setting(report, torus_items(), 5.2);
  setting.bindings = {
      marked("p_a", Role::edge),
      marked("p_b", Role::nearest),
      {"t_s", [=](const NumbersByName& n) {
         return Items{point(Role::claimed, ray.origin + n.rounded("t_s") * ray.direction, "t_s")};
       }}};
  Stage stage = composed_stage(report, walk, setting);
  stage.steps.front().title = "Look at the ray and the torus f = 0";
  const implicit::Torus<float> rounded{static_cast<float>(torus.major), static_cast<float>(torus.minor)};
  const auto roots = implicit::roots(convert<float>(ray), rounded);
  StageStep step;
  step.title = "Enclose all roots by intervals";
  step.view = setting.near;
  step.caption =
      fmt::format("Interval arithmetic says where f cannot be 0, and Newton steps shrink the rest: {} roots.",
                  roots.size());
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const double lo = static_cast<double>(roots[i].lo), hi = static_cast<double>(roots[i].hi);
    step.caption +=
        fmt::format(" t{} in [{}, {}].", subscript(i), shown(lo, one.precision), shown(hi, one.precision));
    step.items.push_back(
        point(Role::exact, ray.origin + 0.5 * (lo + hi) * ray.direction, "t" + subscript(i)));
  }
  stage.steps.push_back(std::move(step));
  stage.steps.push_back(difference_of_values(walk, setting, one.precision));
  stage.method = "implicit::roots";
  stage.source = "D. P. Mitchell, Robust Ray Intersection with Interval Arithmetic, 1990";
  stage.sentence.clear();
  stage.conclusion =
      "A change of sign proves a root; only interval arithmetic proves that there is no other.";
  return stage;
}

namespace {

constexpr std::array<std::array<glm::dvec3, 2>, 2> patch_corners{
    {{{{-1.25, -1, 0.75}, {-1, 1.25, -0.25}}}, {{{1.25, -0.75, -0.25}, {1.5, 1, 1}}}}};

glm::dvec3 on_patch(double u, double v) {
  return (1 - u) * ((1 - v) * patch_corners[0][0] + v * patch_corners[0][1]) +
         u * ((1 - v) * patch_corners[1][0] + v * patch_corners[1][1]);
}

Items patch_items() {
  Items items;
  constexpr int pieces = 8;
  for (int i = 0; i < pieces; ++i) {
    for (int j = 0; j < pieces; ++j) {
      const auto at = [&](int k, int l) {
        return on_patch(static_cast<double>(i + k) / pieces, static_cast<double>(j + l) / pieces);
      };
      items.push_back(polygon(Role::surface, {at(0, 0), at(1, 0), at(1, 1), at(0, 1)}));
    }
  }
  for (const auto& [u, v, name] :
       {std::tuple{0, 0, "r(0, 0)"}, {1, 0, "r(1, 0)"}, {0, 1, "r(0, 1)"}, {1, 1, "r(1, 1)"}})
    items.push_back(point(Role::surface, on_patch(u, v), name));
  return items;
}

}  // namespace

Stage patch_stage(const Case& one, const ReportCase& report_on) {
  const CaseReport report = report_on(one, "");
  const Ray<double>& ray = std::get<RayQuestion>(one.question).ray;
  const Walkthrough walk = record(one.precision, [&]<class R>(std::type_identity<R>) {
    Ray<R> given = convert<R>(ray);
    given.origin = named("o", given.origin);
    given.direction = named("d", given.direction);
    parametric::BilinearPatch<R> patch;
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j) patch.points[i][j] = convert<R>(patch_corners[i][j]);
    (void)parametric::BilinearQuadratic::roots(given, patch);
  });
  Setting setting = surface_setting(report, patch_items(), 5);
  const auto ruling = [](const NumbersByName& n, const char* root) {
    return segment(Role::nearest, on_patch(n[root], 0), on_patch(n[root], 1),
                   fmt::format("the ruling at u = {}", root));
  };
  setting.bindings = {{"q/a", [=](const NumbersByName& n) { return Items{ruling(n, "q/a")}; }},
                      {"c/q", [=](const NumbersByName& n) { return Items{ruling(n, "c/q")}; }},
                      {"t", [=](const NumbersByName& n) {
                         return Items{point(Role::claimed, ray.origin + n.rounded("t") * ray.direction, "t")};
                       }}};
  Stage stage = composed_stage(report, walk, setting);
  stage.steps.front().title = "Look at the ray and the patch r(u, v)";
  // The other ruling is met as the first one was: how it is set up is not shown again.
  const auto meets = [](const StageStep& step) { return step.title.starts_with("Meet the ruling"); };
  const auto last = std::find_if(stage.steps.rbegin(), stage.steps.rend(), meets);
  stage.steps.erase(std::prev(last.base()));
  stage.steps.push_back(difference_of_values(walk, setting, one.precision));
  stage.method = "parametric::bilinear_quadratic";
  stage.source = "A. Reshetov, Cool Patches, Ray Tracing Gems ch. 8, 2019";
  stage.conclusion = "Of both rulings a hit is what has u and v in [0, 1] and t on the ray.";
  return stage;
}

}  // namespace rayproof::viz
