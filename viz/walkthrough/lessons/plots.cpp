#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <rayproof/box/slab.hpp>
#include <rayproof/triangle/barycentric.hpp>

#include "viz/scene/items.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/trace/record.hpp"
#include "viz/walkthrough/compose.hpp"
#include "viz/walkthrough/lesson.hpp"

namespace rayproof::viz {
namespace {

/// The axis of t below the rows, and where a t lies on it.
struct SlabAxis {
  double from, to;
  [[nodiscard]] double at(double t) const { return -1 + 2 * (std::clamp(t, from, to) - from) / (to - from); }
};

template <class R>
void narrate_slabs(const RayQuestion& question) {
  const auto& given = std::get<rayproof::Box<double>>(question.shape);
  const vec3<R> o = named("o", convert<R>(question.ray.origin));
  const vec3<R> d = named("d", convert<R>(question.ray.direction));
  const vec3<R> least = named("min", convert<R>(given.min));
  const vec3<R> most = named("max", convert<R>(given.max));
  step<R>("Meet both x planes",
          "The ray is between them from t = x_in to t = x_out: an interval of the t axis. It enters at min.x "
          "where d.x > 0.");
  const auto x = box::named_slab("x_in", "x_out", box::slab_of(d.x, R(least.x - o.x), R(most.x - o.x)));
  step<R>("Meet both y planes", "The same for y: the two intervals need not overlap.");
  const auto y = box::named_slab("y_in", "y_out", box::slab_of(d.y, R(least.y - o.y), R(most.y - o.y)));
  step<R>("Meet both z planes",
          "For an axis along which d is negative, the ray enters at max and leaves at min.");
  const auto z = box::named_slab("z_in", "z_out", box::slab_of(d.z, R(least.z - o.z), R(most.z - o.z)));
  (void)box::overlap(x, y, z);
}

Binding interval(const SlabAxis& axis, const char* in, const char* out, double y, Role role) {
  return {out, [=](const NumbersByName& n) {
            const glm::dvec3 from{axis.at(n[in]), y, 0};
            const glm::dvec3 to{axis.at(n[out]), y, 0};
            return Items{segment(role, from, to), point(role, from, in), point(role, to, out)};
          }};
}

}  // namespace

/// The triangle and the point of the case in the plane z = 0.
Stage barycentric_stage(const Case& one, const ReportCase& report_on) {
  const CaseReport report = report_on(one, "triangle/plane_projection");
  const auto& question = std::get<RayQuestion>(one.question);
  const auto& triangle = std::get<Triangle<double>>(question.shape);
  Walkthrough walk = record(one.precision, [&]<class R>(std::type_identity<R>) {
    const auto flat = [](const char* name, const glm::dvec3& p) { return named_point<R>(name, {p.x, p.y}); };
    const auto q = flat("q", question.ray.origin);
    const auto a = flat("a", triangle.a), b = flat("b", triangle.b), c = flat("c", triangle.c);
    step<R>("Find the barycentric coordinates", "A step for each value follows.");
    (void)triangle::barycentric(q, a, b, c);
  });
  // One value a step.
  const std::vector<WalkValue> values = walk.steps.front().values;
  static const std::map<std::string, Step> steps{
      {"D",
       {"D is twice the area of the whole",
        "Its sign is + where a, b, c run counterclockwise. Where D = 0 the triangle is seen edge-on, and no "
        "share exists."}},
      {"α",
       {"α is the part opposite a",
        "α is the signed area of q, b, c over that of the whole: negative where q is beyond bc."}},
      {"β",
       {"β is the part opposite b",
        "β is the signed area of q, c, a over that of the whole: negative where q is beyond ca."}},
      {"γ",
       {"γ is what is left for c",
        "The three signed areas add up to the whole, so α + β + γ = 1: γ is negative where q is beyond "
        "ab."}}};
  walk.steps.clear();
  for (const WalkValue& value : values) {
    const auto& [title, meaning] = steps.at(value.name);
    walk.steps.push_back(
        {std::string(title), std::string(meaning), loss_sentence(value.loss), {value}, value.loss});
  }
  Setting setting = plot_setting();
  setting.scene = triangle_items(triangle.a, triangle.b, triangle.c);
  setting.near = setting.wide = view_of({triangle.a, triangle.b, triangle.c}, setting.camera);
  const glm::dvec3 q{question.ray.origin.x, question.ray.origin.y, 0};
  setting.scene.push_back(point(Role::nearest, q, "q"));
  const auto part = [=](const char* name, const glm::dvec3& first, const glm::dvec3& u, const glm::dvec3& v) {
    return Binding{name, [=](const NumbersByName& n) {
                     const bool is_whole = std::string_view(name) == "D";
                     const std::string label = is_whole ? "D/2 = " + rough(n[name] / 2, 3)
                                                        : fmt::format("{} = {}", name, rough(n[name], 3));
                     return outlined(Role::edge, {first, u, v}, label);
                   }};
  };
  setting.bindings = {part("D", triangle.a, triangle.b, triangle.c), part("α", q, triangle.b, triangle.c),
                      part("β", q, triangle.c, triangle.a), part("γ", q, triangle.a, triangle.b)};
  Stage stage = run_stage(report, walk, setting);
  begin_anew(stage, "α is");  // the whole is no share
  const bool is_inside =
      std::ranges::none_of(values, [](const WalkValue& v) { return v.name != "D" && v.value < 0; });
  stage.conclusion =
      fmt::format("{}: q = α·a + β·b + γ·c.", is_inside ? "None is negative, so the point is in the triangle"
                                                        : "One is negative, so the point is outside");
  return stage;
}

Stage intervals_stage(const Case& one, const ReportCase& report_on) {
  const CaseReport report = report_on(one, "box/slabs");
  const auto& question = std::get<RayQuestion>(one.question);
  const Walkthrough walk =
      record(one.precision, [&]<class R>(std::type_identity<R>) { narrate_slabs<R>(question); });
  Setting setting = plot_setting();
  const NumbersByName n(walk, walk.steps.size() - 1);
  const SlabAxis axis{std::min({0.0, n["x_in"], n["y_in"], n["z_in"]}) - 0.3,
                      std::max({n["x_out"], n["y_out"], n["z_out"]}) + 0.3};
  setting.scene = {arrow(Role::ray, {-1.05, -0.62, 0}, {1.05, -0.62, 0}, "t")};
  for (int t = static_cast<int>(std::ceil(axis.from)); t <= axis.to; ++t) {
    const double x = axis.at(t);
    setting.scene.push_back(segment(Role::frame, {x, -0.62, 0}, {x, 0.6, 0}));
    setting.scene.push_back(point(Role::text, {x, -0.69, 0}, std::to_string(t)));
  }
  setting.bindings = {interval(axis, "x_in", "x_out", 0.45, Role::edge),
                      interval(axis, "y_in", "y_out", 0.15, Role::edge),
                      interval(axis, "z_in", "z_out", -0.15, Role::edge),
                      interval(axis, "t_entry", "t_exit", -0.45, Role::nearest)};
  return run_stage(report, walk, setting);
}

}  // namespace rayproof::viz
