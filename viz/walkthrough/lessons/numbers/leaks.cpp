#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <rayproof/triangle/moller_trumbore.hpp>
#include <rayproof/triangle/woop.hpp>

#include "viz/explain/case_report.hpp"
#include "viz/scene/items.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/compose.hpp"
#include "viz/walkthrough/lesson.hpp"
#include "viz/walkthrough/stage_values.hpp"

namespace rayproof::viz {
namespace {

/// Of the second triangle, the corner that the first does not share.
constexpr glm::dvec3 fourth_corner{2.5, 1.8, 1.5};

/// The two triangles a, b, c and b, a, e of a mesh, and the same ray.
Case second_triangle(const Case& one) {
  Case second = one;
  auto& triangle = std::get<Triangle<double>>(std::get<RayQuestion>(second.question).shape);
  const glm::dvec3 fourth = glm::dvec3(glm::vec3(fourth_corner));
  triangle = {triangle.b, triangle.a, fourth};
  return second;
}

/// One of the kernel's steps, under a name.
void add_step(Stage& stage, const CaseReport& report, const Setting& setting, const Step& wanted,
              const std::string& who) {
  const std::size_t index = place_of(report.walk->steps, wanted.title);
  StageStep step = kernel_steps(report, *report.walk, index, setting, false).front();
  step.begins_anew = !stage.steps.back().title.starts_with(who);
  step.title = who + ": " + step.title;
  if (wanted.title != triangle::MollerTrumbore::find_u.title) {
    const std::size_t first = sentences_of(step.words).front().size() + 1;  // it leaves the answer no room
    const std::string verdict = fmt::format(" {} says: {}.", who, verdict_of(report.claim()));
    step.words.erase(0, first);
    step.caption.erase(0, first);
    step.words += verdict;
    step.caption += (step.caption.ends_with(".") ? "" : ".") + verdict;
  }
  stage.steps.push_back(std::move(step));
}

/// A triangle of the two, the report on it, and how far beyond the shared edge its own numbers put the ray.
struct Judge {
  const char* name;
  const CaseReport& report;
  const Triangle<double>& triangle;

  /// v is the share of the height over the edge at which the ray passes: negative beyond it.
  [[nodiscard]] const WalkValue& v() const { return value_named("v", *report.walk); }
  [[nodiscard]] double height() const {
    const glm::dvec3 edge = triangle.b - triangle.a;
    return glm::length(glm::cross(edge, triangle.c - triangle.a)) / glm::length(edge);
  }
};

/// The last step: across the edge, from so near that one sees on which side each triangle puts the ray.
StageStep edge_step(const std::array<Judge, 2>& sides, const Setting& setting) {
  const std::array<double, 2> sign{-1, 1};  // the first triangle lies at the left
  double farthest = 0;
  for (const Judge& side : sides) farthest = std::max(farthest, std::abs(side.v().value) * side.height());
  const auto at = [&](std::size_t i, double v, double up) {
    return sign.at(i) * v * sides.at(i).height() / farthest * 2 * setting.camera.right +
           up * setting.camera.up;
  };
  const auto corner = [&](double x, double y) { return x * setting.camera.right + y * setting.camera.up; };
  StageStep step{.title = comparison_title, .view = {{0, 0, 0}, 1.9}, .is_apart = true};
  step.magnification = 2 / farthest;
  step.items = {open_polygon(Role::surface, {corner(-9, -5), corner(0, -5), corner(0, 5), corner(-9, 5)}),
                open_polygon(Role::surface, {corner(9, -5), corner(0, -5), corner(0, 5), corner(9, 5)}),
                segment(Role::surface, corner(0, -5), corner(0, 5), "the shared edge"),
                point(Role::text, corner(-1.6, -1.3), "the first triangle"),
                point(Role::text, corner(1.6, -1.3), "the second triangle")};
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const WalkValue& v = sides.at(i).v();
    const double up = i == 0 ? 0.8 : -0.4;
    step.items.push_back(point(Role::exact, at(i, v.exact_value, up),
                               fmt::format("exactly, in the {}'s plane", sides.at(i).name)));
    step.items.push_back(
        point(Role::claimed, at(i, v.value, up), fmt::format("as the {} computes it", sides.at(i).name)));
  }
  const auto measured = [](const Judge& side) {
    const double v = side.v().value;
    return fmt::format("the {} computes {}, {}", side.name, rough(v, 3), v < 0 ? "beyond it" : "on its side");
  };
  step.caption =
      fmt::format("Each triangle measures v, the distance from the edge as a share of its height: {}; {}.",
                  measured(sides[0]), measured(sides[1]));
  const bool is_lost = sides[0].v().value < 0 && sides[1].v().value < 0;
  if (is_lost) step.caption += " So neither takes the ray.";
  return step;
}

/// What Woop's two numbers of the shared edge have to do with each other.
std::string same_side_number(const CaseReport& first, const CaseReport& second) {
  const bool is_one = value_named("W", *first.walk).value == -value_named("W", *second.walk).value;
  return is_one
             ? " Both triangles have the same number W for it, with opposite signs: never do both miss there."
             : "";
}

}  // namespace

Stage leak_stage(const Case& one, const ReportCase& report_on) {
  const Case other = second_triangle(one);
  const CaseReport first = report_on(one, "triangle/moller_trumbore");
  const CaseReport second = report_on(other, "triangle/moller_trumbore");
  Setting setting = setting_of(first);
  const auto& triangle = std::get<Triangle<double>>(std::get<RayQuestion>(other.question).shape);
  setting.scene.push_back(polygon(Role::surface, {triangle.a, triangle.b, triangle.c}));
  setting.scene.push_back(polyline(Role::surface, {triangle.b, triangle.c, triangle.a}));
  setting.scene.push_back(point(Role::surface, triangle.c, "e"));
  // The second triangle reaches beyond the view of the first.
  const auto& asked = std::get<RayQuestion>(one.question);
  const auto& triangle_one = std::get<Triangle<double>>(asked.shape);
  setting.near =
      view_of({triangle.a, triangle.b, triangle.c, triangle_one.c, asked.ray.origin}, setting.camera);
  setting.wide = setting.near;
  Stage stage = stage_of(first);
  stage.scene = setting.scene;
  stage.steps.resize(1);
  using triangle::MollerTrumbore, triangle::Woop;
  for (const Step& wanted : {MollerTrumbore::find_u, MollerTrumbore::find_v})
    add_step(stage, first, setting, wanted, "The first triangle");
  for (const Step& wanted : {MollerTrumbore::find_u, MollerTrumbore::find_v})
    add_step(stage, second, setting, wanted, "The second triangle");
  const CaseReport woop_first = report_on(one, "triangle/woop");
  const CaseReport woop_second = report_on(other, "triangle/woop");
  add_step(stage, woop_first, setting, Woop::find_sides, "Woop, the first");
  add_step(stage, woop_second, setting, Woop::find_sides, "Woop, the second");
  stage.steps.back().caption += same_side_number(woop_first, woop_second);
  stage.steps.push_back(edge_step({{{"first", first, triangle_one}, {"second", second, triangle}}}, setting));
  // One view for all, so that nothing jumps.
  StageView view = setting.near;
  for (const StageStep& step : stage.steps) {
    if (!step.is_apart) view.radius = radius_for(view, step.items, setting.camera);
  }
  for (StageStep& step : stage.steps) {
    if (!step.is_apart) step.view = view;
  }
  const bool is_lost =
      verdicts_differ(&first.exact, first.claim()) || verdicts_differ(&second.exact, second.claim());
  stage.conclusion =
      fmt::format("Exactly: {} and {}. Möller–Trumbore: {} and {}{}. Woop: {} and {}.",
                  verdict_of(&first.exact), verdict_of(&second.exact), verdict_of(first.claim()),
                  verdict_of(second.claim()), is_lost ? "; the ray slips between" : "",
                  verdict_of(woop_first.claim()), verdict_of(woop_second.claim()));
  stage.steps.back().digits = stage.conclusion;
  return stage;
}

}  // namespace rayproof::viz
