#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <rayproof/spawn.hpp>

#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/bindings.hpp"
#include "viz/walkthrough/compose.hpp"
#include "viz/walkthrough/lesson.hpp"

namespace rayproof::viz {
namespace {

/// From the exact t, rounded, to the origin of the next ray.
template <class R>
void leave_sphere(const RayQuestion& question, double t) {
  const Ray<R> ray = named_ray<R>(question.ray);
  Sphere<R> sphere = convert<R>(std::get<Sphere<double>>(question.shape));
  sphere.center = named("C", sphere.center);
  sphere.radius = named("r", sphere.radius);

  step<R>("Go to the hit, as far as rounding allows",
          "However good t is, the point is rounded in each coordinate: it lies beside the sphere.");
  const vec3<R> p = named("p", point_at(ray, R(t)));

  step<R>("Move it onto the sphere",
          "The centre and r times a direction make a point of the sphere, whatever the direction's "
          "rounding: only the sphere's own numbers still count.");
  const spawn::SurfacePoint<R> from = spawn::leave(sphere, p);
  (void)named("q", from.point);
  (void)named("n", from.normal);
  (void)spawn::Proven::origin(from);
}

/// How far outside the sphere a point of the run is, as it was rounded.
double height_of(const NumbersByName& n, const std::string& point, const Sphere<double>& sphere) {
  const auto along = [&](const char* axis, double centre) {
    return Shadow(n.rounded(point + axis)) - centre;
  };
  const Shadow x = along(".x", sphere.center.x), y = along(".y", sphere.center.y),
               z = along(".z", sphere.center.z);
  return static_cast<double>(sqrt(x * x + y * y + z * z) - sphere.radius);
}

/// "2.1e-7 below", or "on it".
std::string beside(double height) {
  if (height == 0) return "on it";
  return rough(std::abs(height), 3) + (height < 0 ? " below" : " above");
}

/// Hit, moved point and origin over the sphere's surface, magnified until they can be distinguished.
StageStep heights_step(const NumbersByName& n, const Sphere<double>& sphere, const Setting& setting) {
  const double hit = height_of(n, "p", sphere), moved = height_of(n, "q", sphere),
               origin = height_of(n, "o′", sphere);
  StageStep step{.title = comparison_title, .view = {{}, 1.3}, .is_apart = true};
  step.caption =
      fmt::format("Exactly, p is {} the sphere, q is {}, and o′ is {}: the next ray starts outside.",
                  beside(hit), beside(moved), beside(origin));
  step.magnification = 1 / std::max({std::abs(hit), std::abs(moved), std::abs(origin)});
  const auto at = [&](double sideways, double height) {
    return sideways * setting.camera.right + step.magnification * height * setting.camera.up;
  };
  step.items = ground_of(setting.camera);
  append(step.items, {point(Role::text, at(0.8, -0.15 / step.magnification), "the sphere"),
                      point(Role::claimed, at(0, hit), "p"), point(Role::nearest, at(0, moved), "q"),
                      arrow(Role::normal, at(0, moved), at(0, origin), "along n"),
                      point(Role::claimed, at(0, origin), "o′")});
  return step;
}

/// The plane that touches the sphere at q.
Items tangent_plane(const NumbersByName& n) {
  const glm::dvec3 q = n.vector("q"), along = across(n.vector("n")),
                   beside = glm::cross(n.vector("n"), along);
  const double reach = 0.6 / n["bend"];
  std::vector<glm::dvec3> corners;
  for (const auto& [x, y] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}})
    corners.push_back(q + reach * (x * along + y * beside));
  return {polygon(Role::nearest, corners, "tangent plane")};
}

/// What the next origin may be off round q, so near that the sphere is a plane: the box of its coordinates,
/// and how far that reaches along the normal.
void show_room(StageStep& step, const NumbersByName& n) {
  const glm::dvec3 room = n.vector("room"), normal = n.vector("n"), along = across(normal),
                   beside = glm::cross(normal, along);
  step.is_apart = step.is_other_space = true;
  step.magnification = 1 / glm::length(room);
  const glm::dvec3 half = step.magnification * room;
  StageItem box{.role = Role::nearest, .form = Form::solid, .label = "room"};
  for (unsigned i = 0; i < 8; ++i)
    box.points.push_back(half *
                         glm::dvec3((i & 1U) != 0 ? 1 : -1, (i & 2U) != 0 ? 1 : -1, (i & 4U) != 0 ? 1 : -1));
  box.faces = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
  constexpr double wide = 1.4;
  step.items = {polygon(Role::surface, {-wide * (along + beside), wide * (along - beside),
                                        wide * (along + beside), wide * (beside - along)}),
                point(Role::text, 0.72 * wide * (beside - along), "the sphere"), box,
                point(Role::nearest, {0, 0, 0}, "q")};
  if (n.has("reach"))
    step.items.push_back(arrow(Role::normal, {0, 0, 0}, step.magnification * n["reach"] * normal, "reach"));
  step.view = {{}, 1.5};
}

}  // namespace

Stage leaving_stage(const Case& one, const ReportCase& report_on) {
  const CaseReport report = report_on(one, "");
  const auto& question = std::get<RayQuestion>(one.question);
  const auto& sphere = std::get<Sphere<double>>(question.shape);
  const double t = std::get<RayAnswer>(report.exact).hits.t[0];
  const Walkthrough walk =
      record(one.precision, [&]<class R>(std::type_identity<R>) { leave_sphere<R>(question, t); });
  Setting setting = setting_of(report);
  setting.bindings = {marked("p", Role::claimed),
                      marked("q", Role::nearest),
                      {"n",
                       [=](const NumbersByName& n) {
                         return Items{arrow(Role::normal, n.vector("q"),
                                            n.vector("q") + 0.5 * sphere.radius * n.vector("n"), "n")};
                       }},
                      {"bend", tangent_plane},
                      marked("o′", Role::claimed)};
  Stage stage = composed_stage(report, walk, setting);
  for (std::size_t i = 0; i < walk.steps.size(); ++i) {
    const NumbersByName n(walk, i);
    if (n.has_vector("room") && !n.has("bend"))
      show_room(stage.steps.at(i + 1), n);  // after the one that shows what is given
  }
  stage.steps.push_back(heights_step(NumbersByName(walk, walk.steps.size() - 1), sphere, setting));
  return stage;
}

}  // namespace rayproof::viz
