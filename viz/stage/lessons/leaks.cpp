#include <fmt/format.h>

#include <cmath>

#include "viz/answers.hpp"
#include "viz/stage/compose.hpp"
#include "viz/stage/kernel_steps.hpp"
#include "viz/stage/lessons.hpp"
#include "viz/stage/stage_of.hpp"

namespace rayproof::viz {
namespace {

/// Of the second triangle, the corner that the first does not share.
constexpr glm::dvec3 fourth_corner{2.5, 1.8, 1.5};

/// The two triangles a, b, c and b, a, d of a mesh, and the same ray.
Case second_triangle(const Case& one) {
  Case second = one;
  auto& triangle = std::get<Triangle<double>>(std::get<RayQuestion>(second.question).shape);
  const glm::dvec3 fourth = glm::dvec3(glm::vec3(fourth_corner));
  triangle = {triangle.b, triangle.a, fourth};
  return second;
}

/// The kernel's steps whose titles begin so, under a name.
void add_steps(Stage& stage, const Told& told, const Setting& setting, const std::string& title,
               const std::string& who) {
  for (std::size_t i = 0; i < told.walk->steps.size(); ++i) {
    if (!told.walk->steps[i].title.starts_with(title)) continue;
    for (StageStep& step : kernel_steps(told, *told.walk, i, setting, false)) {
      step.title = who + ": " + step.title;
      step.words = fmt::format("{} says: {}.", who, verdict_of(told.claim()));
      step.caption = step.words + " " + step.caption;
      stage.steps.push_back(std::move(step));
    }
  }
}

Stage leak_stage(const Case& one, const TellCase& tell) {
  const Case other = second_triangle(one);
  const Told first = tell(one, "triangle/moller_trumbore");
  const Told second = tell(other, "triangle/moller_trumbore");
  Setting setting = setting_of(first);
  const auto& triangle = std::get<Triangle<double>>(std::get<RayQuestion>(other.question).shape);
  setting.scene.push_back(polygon(Role::surface, {triangle.a, triangle.b, triangle.c}));
  setting.scene.push_back(polyline(Role::surface, {triangle.b, triangle.c, triangle.a}));
  setting.scene.push_back(point(Role::surface, triangle.c, "d"));
  // The second triangle reaches beyond the view of the first.
  const RayQuestion& asked = std::get<RayQuestion>(one.question);
  setting.near = view_around(
      {triangle.a, triangle.b, triangle.c, std::get<Triangle<double>>(asked.shape).c, asked.ray.origin});
  setting.wide = setting.near;
  Stage stage = stage_of(first);
  stage.scene = setting.scene;
  stage.steps.resize(1);
  stage.steps.front().title = "Look at two triangles with one edge, and a ray at it";
  add_steps(stage, first, setting, "Find u", "The first triangle");
  add_steps(stage, first, setting, "Find v", "The first triangle");
  add_steps(stage, second, setting, "Find u", "The second triangle");
  add_steps(stage, second, setting, "Find v", "The second triangle");
  const Told woop_first = tell(one, "triangle/woop");
  const Told woop_second = tell(other, "triangle/woop");
  add_steps(stage, woop_first, setting, "Find the side", "Woop, the first");
  add_steps(stage, woop_second, setting, "Find the side", "Woop, the second");
  // Of the two, the one that wrongly says miss.
  StageStep last = parting_step(verdicts_differ(&first.exact, first.claim()) ? first : second, setting);
  last.view = setting.near;
  stage.steps.push_back(last);
  stage.method = "triangle/moller_trumbore";
  stage.conclusion = fmt::format(
      "Exactly: {} and {}. Möller–Trumbore: {} and {}; the ray slips between. Woop: {} and {}.",
      verdict_of(&first.exact), verdict_of(&second.exact), verdict_of(first.claim()),
      verdict_of(second.claim()), verdict_of(woop_first.claim()), verdict_of(woop_second.claim()));
  stage.steps.back().digits = stage.conclusion;
  return stage;
}

}  // namespace

std::vector<Lesson> leak_lessons() {
  return {
      {"leak", "numbers", "A leak between two triangles",
       "Each triangle judges the shared edge by its own rounded numbers, and both say that the ray passes on "
       "the other's "
       "side.",
       R"({"precision": "float32", "ray": {"origin": [-2.7, -0.5, 6], "direction": [4.89000034, 1.73000002, -6.9000001]},
           "shape": {"type": "triangle", "a": [2.7, 1.1, -1.1], "b": [-2.4, 2.4, 0.9], "c": [0.1, -1.9, -2.8]}})",
       "", leak_stage},
  };
}

}  // namespace rayproof::viz
