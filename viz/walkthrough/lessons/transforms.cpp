#include <fmt/format.h>

#include <rayproof/transform.hpp>

#include "viz/scene/items.hpp"
#include "viz/shapes/ray_walk.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/bindings.hpp"
#include "viz/walkthrough/compose.hpp"
#include "viz/walkthrough/lesson.hpp"

namespace rayproof::viz {
namespace {

/// Lets the step whose title begins so show items of another space at the right of all that is in the world;
/// the next step begins anew.
void show_beside(Stage& stage, const std::string& title, const Items& items) {
  const std::size_t number = place_of(stage.steps, title);
  const auto seen_of = [&](const Items& some) {
    return view_of(extent_of(some, stage.camera), stage.camera);
  };
  const StageView world = seen_of(stage.scene);
  const StageView own = seen_of(items);
  const double shift = view_aspect * (world.radius + own.radius);
  StageStep& step = stage.steps.at(number);
  step.items = items;
  for (StageItem& item : step.items) {
    for (glm::dvec3& p : item.points) p += world.centre - own.centre + shift * stage.camera.right;
  }
  Items all = stage.scene;
  append(all, step.items);
  step.view = seen_of(all);
  stage.steps.at(number + 1).begins_anew = true;
}

/// The hit of the object's own space, mapped back: it is p(t₀).
StageStep back_in_the_world(const CaseReport& report, const NumbersByName& n, const Stage& stage) {
  const auto& question = std::get<RayQuestion>(report.one.question);
  const double t = n["t₀"];
  const glm::dvec3 q = n.at(t);
  const glm::dvec3 p = question.ray.origin + t * question.ray.direction;
  const auto vector = [](const glm::dvec3& v) {
    return fmt::format("({}, {}, {})", rough(v.x, 5), rough(v.y, 5), rough(v.z, 5));
  };
  StageStep step{.title = "Take the hit back into the world",
                 .items = {point(Role::claimed, p, "M·q = p(t₀)")},
                 .view = stage.steps.front().view,
                 .begins_anew = true};
  step.words = step.caption = fmt::format(
      "M·q = A·q + T takes q = o′ + t₀·d = {} to {}, which is p(t₀). Had d been normalised, t would be "
      "|d|·t₀ = {} there, which is not the t of this ray.",
      vector(q), vector(p), rough(t * glm::length(n.direction()), 5));
  return step;
}

template <class R>
void carry_normal(const RayQuestion& question, double t) {
  const auto [a, b, c, translation] = named_columns<R>(*question.transform);
  const ObjectSpace<R> space = object_space<R>(a, b, c, translation);

  step<R>("Take the hit into the object's own space",
          "The inverse map applies to the ray; q is the point of the mapped ray at the same t.");
  const Ray<R> inside = to_object(space, convert<R>(question.ray));
  const vec3<R> q = named("q", point_at(inside, R(t)));

  step<R>("There the normal of the unit sphere is the point itself",
          "The sphere's radius ends at q and is perpendicular to the surface.");
  const R r = named("r", R(std::get<Sphere<double>>(question.shape).radius));
  const vec3<R> normal = named("n", vec3<R>{q.x / r, q.y / r, q.z / r});

  step<R>("Carried like a direction, by A, it is not perpendicular: wrong",
          "A maps tangents to tangents, but does not preserve the right angle between them and the normal.");
  (void)named("A·n", vec3<R>(normal.x * a + normal.y * b + normal.z * c));

  step<R>("Carried by the inverse transpose it is perpendicular",
          "m = A⁻ᵀ·n: its product with A·u is n·u, which is 0 for every tangent u, so m is perpendicular to "
          "the surface. A·u is the tangent in the world.");
  (void)named("m", vec3<R>(normal.x * space.row_x + normal.y * space.row_y + normal.z * space.row_z));
}

}  // namespace

/// Beside the world, the object's own space: the unit sphere and the ray as it sees it.
Stage transformed_stage(const Case& one, const ReportCase& report_on) {
  const CaseReport report = report_on(one, "sphere/centred");
  Stage stage = stage_of(report);
  const NumbersByName n(*report.walk, report.walk->steps.size() - 1);
  show_beside(stage, "Take the ray into",
              {ball({0, 0, 0}, 1), arrow(Role::ray, n.origin(), n.at(n["t₁"] * 1.25), "o′ + t·d"),
               point(Role::ray, n.origin(), "o′"),
               point(Role::text, -1.7 * stage.camera.up, "the object's own space")});
  stage.steps.insert(stage.steps.end() - 1, back_in_the_world(report, n, stage));
  return stage;
}

Stage normal_stage(const Case& one, const ReportCase& report_on) {
  const CaseReport report = report_on(one, "sphere/centred");
  const auto& question = std::get<RayQuestion>(one.question);
  const double t = std::get<RayAnswer>(report.exact).hits.t[0];
  const Walkthrough walk =
      record(one.precision, [&]<class R>(std::type_identity<R>) { carry_normal<R>(question, t); });
  Setting setting = setting_of(report);
  const glm::dvec3 hit = question.ray.origin + t * question.ray.direction;
  const auto at_hit = [=](const char* name, Role role, const char* label) {
    return Binding{name, [=](const NumbersByName& n) {
                     return Items{arrow(role, hit, hit + resized(n.vector(name), 0.9), label)};
                   }};
  };
  // The items lie in the world already, or in the object's own space.
  const auto as_it_is = [](const glm::dvec3& p) { return p; };
  setting.to_world = as_it_is;
  setting.bindings = {at_hit("A·n", Role::claimed, "A·n, wrong"), at_hit("m", Role::normal, "m = A⁻ᵀ·n")};
  const std::vector<Binding> on_unit_sphere{
      marked("q", Role::nearest),
      {"n", [](const NumbersByName& n) {
         return Items{arrow(Role::normal, n.vector("q"), n.vector("q") + 0.9 * n.vector("n"), "n = q")};
       }}};
  setting.spaces = {{walk.steps.at(0).title, "Drawn in the object's own space.",
                     [=](const NumbersByName& /*n*/) {
                       return Items{ball({0, 0, 0}, 1)};
                     },
                     as_it_is, on_unit_sphere},
                    {walk.steps.at(2).title}};
  Stage stage = run_stage(report, walk, setting);
  // The tangent plane makes it plain which of the two is perpendicular.
  const glm::dvec3 normal = *std::get<RayAnswer>(report.exact).normal;
  const glm::dvec3 u = 0.7 * across(normal);
  const glm::dvec3 v = glm::cross(normal, u);
  append(stage.steps.at(3).items, outlined(Role::edge, {hit + u + v, hit + u - v, hit - u - v, hit - u + v}));
  return stage;
}

}  // namespace rayproof::viz
