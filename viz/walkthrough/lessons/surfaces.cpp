#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <rayproof/implicit/roots.hpp>
#include <rayproof/implicit/torus.hpp>
#include <rayproof/parametric/bilinear_quadratic.hpp>

#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/bindings.hpp"
#include "viz/walkthrough/compose.hpp"
#include "viz/walkthrough/lesson.hpp"

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

/// The point where f is taken, from the centre; and the circle of radius R round which the torus lies.
Items from_centre(const NumbersByName& n) {
  const std::string p = n.has_vector("p_b") ? "p_b" : "p_a";
  return {level_ring(Role::edge, torus.major, torus.major, 0),
          segment(Role::edge, {0, 0, 0}, {-torus.major, 0, 0}, "R"),
          arrow(Role::nearest, {0, 0, 0}, n.vector(p))};
}

Items height_over_circle(const NumbersByName& n) {
  const glm::dvec3 p = n.vector(n.has_vector("p_b") ? "p_b" : "p_a");
  return {segment(Role::nearest, {p.x, p.y, 0}, p, "z")};
}

Items both_points(const NumbersByName& n) {
  return {point(Role::edge, n.vector("p_a"), "p_a"), point(Role::nearest, n.vector("p_b"), "p_b")};
}

template <class R>
void close_in(const Ray<double>& given, double before, double behind) {
  const Ray<R> ray = named_ray<R>(given);
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

Stage torus_stage(const Case& one, const ReportCase& report_on) {
  const CaseReport report = report_on(one, "");
  const Ray<double>& ray = std::get<RayQuestion>(one.question).ray;
  constexpr double before = 1, behind = 1.5;
  const Walkthrough walk =
      record(one.precision, [&]<class R>(std::type_identity<R>) { close_in<R>(ray, before, behind); });
  Setting setting = surface_setting(report, torus_items(), 5.2);
  setting.bindings = {
      marked("p_a", Role::edge),
      {"p_b", both_points},
      {"Compare the distance from the centre with that of the circle", from_centre},
      {"Add what the height above the circle's plane makes of it", height_over_circle},
      {"t_s", [=](const NumbersByName& n) {
         Items items = both_points(n);
         items.push_back(point(Role::claimed, ray.origin + n.rounded("t_s") * ray.direction, "t_s"));
         return items;
       }}};
  Stage stage = composed_stage(report, walk, setting);
  for (const char* const title : {"Take a point inside", "Guess"}) begin_anew(stage, title);
  const implicit::Torus<float> rounded{static_cast<float>(torus.major), static_cast<float>(torus.minor)};
  const auto roots = implicit::roots(convert<float>(ray), rounded);
  StageStep step{.title = "Enclose all roots by intervals", .view = setting.near, .begins_anew = true};
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
  return stage;
}

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
  Stage stage = run_stage(report, walk, setting);
  for (const char* const title : {"Let the volume", "Form the discriminant"}) begin_anew(stage, title);
  // The other ruling is met as the first one was: how it is set up is not shown again.
  const auto meets = [](const StageStep& step) { return step.title.starts_with("Meet the ruling"); };
  const auto last = std::find_if(stage.steps.rbegin(), stage.steps.rend(), meets);
  stage.steps.erase(std::prev(last.base()));
  return stage;
}

}  // namespace rayproof::viz
