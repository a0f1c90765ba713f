#include <algorithm>
#include <rayproof/formulas/largest_axis.hpp>
#include <rayproof/formulas/polygon_sides.hpp>
#include <rayproof/plane/point_normal.hpp>

#include "viz/scene/items.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/bindings.hpp"
#include "viz/walkthrough/compose.hpp"
#include "viz/walkthrough/lesson.hpp"
#include "viz/walkthrough/setting.hpp"

namespace rayproof::viz {
namespace {

/// Where the sides of the projected polygon cross a ray along +x from the projected point.
template <class R>
void cross_projected(const LargestAxisLast<R>& turned, const vec3<R>& q,
                     const std::vector<vec3<R>>& vertices) {
  step<R>("Count the sides that a ray along +x crosses there",
          "s is the place on the side and t that on the ray: an odd number of crossings with t > 0 means "
          "inside.");
  const Vec2<R> p = turned.dropped(q);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec2<R> a = turned.dropped(vertices[i]);
    const Vec2<R> b = turned.dropped(vertices[polygon::next(i, vertices.size())]);
    const auto plain = [](const R& x) { return static_cast<double>(x.value()); };
    if (!polygon::passes(plain(p.y), Vec2<double>{plain(a.x), plain(a.y)},
                         Vec2<double>{plain(b.x), plain(b.y)}))
      continue;
    const auto [s, t] = polygon::cross_side(p, a, b);
    (void)named(("s" + subscript(i)).c_str(), s);
    (void)named(("t" + subscript(i)).c_str(), t);
  }
}

template <class R>
void meet_polygon(const RayQuestion& question) {
  const Ray<R> ray = named_ray<R>(question.ray);
  std::vector<vec3<R>> vertices;
  for (const glm::dvec3& v : std::get<rayproof::Polygon<double>>(question.shape).vertices)
    vertices.push_back(named(("v" + subscript(vertices.size())).c_str(), convert<R>(v)));
  step<R>(
      "Form the Newell normal",
      "n is the sum of the cross products of neighbouring vertices: perpendicular to the polygon, twice its "
      "area long.");
  const vec3<R> n = named("n", polygon::newell_normal<R>(vertices, vertices.front()));
  const R t = plane::meet(ray, vertices.front(), n).lo;
  const vec3<R> q = named("q", point_at(ray, t));
  step<R>(steps::project_along_largest_axis);
  cross_projected(LargestAxisLast<R>(n), q, vertices);
}

Items projected_scene(const NumbersByName& n, std::size_t count) {
  const auto at = [&](const std::string& name) { return dropped(n.vector("n"), n.vector(name)); };
  std::vector<glm::dvec3> ring;
  Items items;
  for (std::size_t i = 0; i < count; ++i) ring.push_back(at("v" + subscript(i)));
  items.push_back(polygon(Role::surface, ring));
  for (std::size_t i = 0; i < count; ++i) items.push_back(point(Role::surface, ring[i], "v" + subscript(i)));
  const glm::dvec3 q = at("q");
  double end = q.x;
  for (const glm::dvec3& p : ring) end = std::max(end, p.x);
  items.push_back(arrow(Role::ray, q, {end + 0.4, q.y, 0}, "+x"));
  items.push_back(point(Role::nearest, q, "q"));
  for (std::size_t i = 0; i < count; ++i) {
    const std::string t = "t" + subscript(i);
    if (n.has(t))
      items.push_back(point(n[t] > 0 ? Role::claimed : Role::muted, q + glm::dvec3(n[t], 0, 0), t));
  }
  return items;
}

}  // namespace

Stage polygon_stage(const Case& one, const ReportCase& report_on) {
  const CaseReport report = report_on(one, "polygon/parity");
  const auto& question = std::get<RayQuestion>(one.question);
  const std::size_t count = std::get<rayproof::Polygon<double>>(question.shape).vertices.size();
  const Walkthrough walk =
      record(one.precision, [&]<class R>(std::type_identity<R>) { meet_polygon<R>(question); });
  Setting setting = setting_of(report);
  const auto first = std::get<rayproof::Polygon<double>>(question.shape).vertices.front();
  setting.bindings = {
      {"n",
       [=](const NumbersByName& n) {
         return Items{arrow(Role::normal, first, first + resized(n.vector("n"), 1), "n")};
       }},
      {"n·(p - o)", [=](const NumbersByName& n) { return way_to_plane(n, n.vector("n"), first); }},
      answer("t"),
      marked("q", Role::nearest)};
  setting.spaces = {{"Project along",
                     "Drawn in the projection.",
                     [=](const NumbersByName& n) { return projected_scene(n, count); },
                     flat_on(setting.camera),
                     {},
                     true}};
  Stage stage = composed_stage(report, walk, setting);
  stage.steps.push_back(difference_step(report, setting));
  stage.steps.back().begins_anew = true;
  stage.steps.back().digits.clear();  // the caption has it; it is not the method that was recorded
  return stage;
}

}  // namespace rayproof::viz
