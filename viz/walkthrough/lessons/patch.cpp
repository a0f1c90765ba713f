#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <rayproof/parametric/bilinear_quadratic.hpp>

#include "viz/walkthrough/bindings.hpp"
#include "viz/walkthrough/compose.hpp"
#include "viz/walkthrough/lesson.hpp"

namespace rayproof::viz {
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

/// From the ray's origin to the corner r(0, 0), on along both its edges, and what the second gains along the
/// first.
Items edges_of_patch(const NumbersByName& n) {
  const glm::dvec3 corner = on_patch(0, 0), along_u = on_patch(1, 0), along_v = on_patch(0, 1);
  return {arrow(Role::nearest, n.origin(), corner, "p"), arrow(Role::edge, corner, along_u, "p_u"),
          arrow(Role::edge, corner, along_v, "e"),
          arrow(Role::edge, along_u + along_v - corner, on_patch(1, 1), "e_u")};
}

Items some_rulings(const NumbersByName& /*n*/) {
  constexpr int pieces = 4;
  Items rulings;
  for (int i = 0; i <= pieces; ++i) {
    const double u = static_cast<double>(i) / pieces;
    rulings.push_back(segment(Role::nearest, on_patch(u, 0), on_patch(u, 1),
                              2 * i == pieces ? "the ruling at u = 1/2" : ""));
  }
  return rulings;
}

}  // namespace

Stage patch_stage(const Case& one, const ReportCase& report_on) {
  const CaseReport report = report_on(one, "");
  const Ray<double>& ray = std::get<RayQuestion>(one.question).ray;
  const Walkthrough walk = record(one.precision, [&]<class R>(std::type_identity<R>) {
    const Ray<R> given = named_ray<R>(ray);
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
  setting.bindings = {{"Move the ray's origin to the origin", edges_of_patch},
                      {"Let the volume of direction, edge point and ruling be 0", some_rulings},
                      {"q/a", [=](const NumbersByName& n) { return Items{ruling(n, "q/a")}; }},
                      {"c/q", [=](const NumbersByName& n) { return Items{ruling(n, "c/q")}; }},
                      {"t", [=](const NumbersByName& n) {
                         return Items{point(Role::claimed, ray.origin + n.rounded("t") * ray.direction, "t")};
                       }}};
  Stage stage = composed_stage(report, walk, setting);
  stage.steps.front().title = "Look at the ray and the patch r(u, v)";
  for (const char* const title : {"Let the volume", "Form the discriminant"}) begin_anew(stage, title);
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
