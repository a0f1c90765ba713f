#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <rayproof/triangle/barycentric.hpp>

#include "viz/scene/items.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/trace/record.hpp"
#include "viz/walkthrough/compose.hpp"
#include "viz/walkthrough/lesson.hpp"

namespace rayproof::viz {

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
  Setting setting = plot_setting(report);
  setting.scene = triangle_items(triangle.a, triangle.b, triangle.c);
  setting.near = setting.wide = view_of({triangle.a, triangle.b, triangle.c}, setting.camera);
  setting.slider.reset();
  const glm::dvec3 q{question.ray.origin.x, question.ray.origin.y, 0};
  setting.scene.push_back(point(Role::nearest, q, "q"));
  const auto part = [=](const char* name, const glm::dvec3& first, const glm::dvec3& u, const glm::dvec3& v) {
    return Binding{
        name, [=](const NumbersByName& n) {
          const bool is_whole = std::string_view(name) == "D";
          const std::string label =
              is_whole ? "D/2 = " + rough(n[name] / 2, 3) : fmt::format("{} = {}", name, rough(n[name], 3));
          return Items{polygon(Role::edge, {first, u, v}, label), polyline(Role::edge, {first, u, v, first})};
        }};
  };
  setting.bindings = {part("D", triangle.a, triangle.b, triangle.c), part("α", q, triangle.b, triangle.c),
                      part("β", q, triangle.c, triangle.a), part("γ", q, triangle.a, triangle.b)};
  Stage stage = composed_stage(report, walk, setting);
  stage.steps.front().title = "Look at the triangle and the point";
  stage.method = "triangle::barycentric";
  begin_anew(stage, "α is");  // the whole is no share
  stage.steps.push_back(difference_of_values(walk, setting, one.precision));
  const bool is_inside =
      std::ranges::none_of(values, [](const WalkValue& v) { return v.name != "D" && v.value < 0; });
  stage.conclusion =
      fmt::format("{}: q = α·a + β·b + γ·c.", is_inside ? "None is negative, so the point is in the triangle"
                                                        : "One is negative, so the point is outside");
  return stage;
}

}  // namespace rayproof::viz
