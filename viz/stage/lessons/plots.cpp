#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <rayproof/box/slab.hpp>
#include <rayproof/triangle/barycentric.hpp>

#include "viz/numbers.hpp"
#include "viz/stage/compose.hpp"
#include "viz/stage/fit_view.hpp"
#include "viz/stage/lessons.hpp"
#include "viz/stage/stage_of.hpp"

namespace rayproof::viz {
namespace {

/// A drawing of rows over an axis in the plane of the screen.
Setting plot_setting(const Told& told) {
  Setting setting = setting_of(told);
  setting.camera = {};
  setting.camera.is_flat = true;
  setting.scene.clear();
  setting.near = setting.wide = {{0, 0, 0}, 0.8};
  setting.to_world = [](const glm::dvec3& p) { return p; };
  return setting;
}

/// The axis of t below the rows, and where a t lies on it.
struct Axis {
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
  step<R>("Meet both x planes");
  const auto slab = [](const R& speed, const R& below, const R& above, const char* in, const char* out) {
    const box::Slab<R> one = box::slab_of(speed, below, above);
    return box::Slab<R>{named(in, one.entry), named(out, one.exit)};
  };
  const auto x = slab(d.x, R(least.x - o.x), R(most.x - o.x), "x_in", "x_out");
  step<R>("Meet both y planes");
  const auto y = slab(d.y, R(least.y - o.y), R(most.y - o.y), "y_in", "y_out");
  step<R>("Meet both z planes");
  const auto z = slab(d.z, R(least.z - o.z), R(most.z - o.z), "z_in", "z_out");
  (void)box::overlap(x, y, z);
}

Binding interval(const Axis& axis, const char* in, const char* out, double y, Role role) {
  return {out, [=](const NumbersByName& n) {
            const glm::dvec3 from{axis.at(n[in]), y, 0};
            const glm::dvec3 to{axis.at(n[out]), y, 0};
            return Items{segment(role, from, to), point(role, from, in), point(role, to, out)};
          }};
}

Stage intervals_stage(const Case& one, const TellCase& tell) {
  const Told told = tell(one, "box/slabs");
  const auto& question = std::get<RayQuestion>(one.question);
  const Walkthrough walk =
      record(one.precision, [&]<class R>(std::type_identity<R>) { narrate_slabs<R>(question); });
  Setting setting = plot_setting(told);
  const NumbersByName n(walk, walk.steps.size() - 1);
  const Axis axis{std::min({0.0, n["x_in"], n["y_in"], n["z_in"]}) - 0.3,
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
  setting.slider.reset();
  Stage stage = composed_stage(told, walk, setting);
  stage.steps.front().title = "Measure the ray by its t axis";
  for (StageStep& step : stage.steps) {
    std::erase_if(step.items, [](const StageItem& item) { return item.role == Role::claimed; });
  }
  stage.method = "box/slabs";
  stage.steps.push_back(parting_of_values(walk, setting, one.precision));
  stage.conclusion = "A box is where three intervals overlap.";
  return stage;
}

/// The triangle and the point of the case in the plane z = 0.
Stage barycentric_stage(const Case& one, const TellCase& tell) {
  const Told told = tell(one, "triangle/plane_projection");
  const auto& question = std::get<RayQuestion>(one.question);
  const auto& triangle = std::get<Triangle<double>>(question.shape);
  Walkthrough walk = record(one.precision, [&]<class R>(std::type_identity<R>) {
    const auto flat = [](const char* name, const glm::dvec3& p) {
      const std::string text = name;
      return Vec2<R>{named((text + ".x").c_str(), R(p.x)), named((text + ".y").c_str(), R(p.y))};
    };
    const auto q = flat("q", question.ray.origin);
    const auto a = flat("a", triangle.a);
    const auto b = flat("b", triangle.b);
    const auto c = flat("c", triangle.c);
    step<R>("");
    (void)triangle::barycentric(q, a, b, c);
  });
  // One value a step.
  const std::vector<WalkValue> values = walk.steps.front().values;
  static constexpr const char* titles[] = {"D is twice the area of the whole", "α is the part opposite a",
                                           "β is the part opposite b", "γ is what is left for c"};
  walk.steps.clear();
  for (std::size_t i = 0; i < values.size(); ++i)
    walk.steps.push_back({titles[i], loss_sentence(values[i].loss), {values[i]}, {}, values[i].loss});
  Setting setting = plot_setting(told);
  setting.scene = {polygon(Role::surface, {triangle.a, triangle.b, triangle.c}),
                   polyline(Role::surface, {triangle.a, triangle.b, triangle.c, triangle.a}),
                   point(Role::surface, triangle.a, "a"), point(Role::surface, triangle.b, "b"),
                   point(Role::surface, triangle.c, "c")};
  setting.near = setting.wide = view_of({triangle.a, triangle.b, triangle.c}, setting.camera);
  setting.slider.reset();
  const glm::dvec3 q{question.ray.origin.x, question.ray.origin.y, 0};
  setting.scene.push_back(point(Role::nearest, q, "q"));
  const auto part = [=](const char* name, const glm::dvec3& first, const glm::dvec3& u, const glm::dvec3& v) {
    return Binding{
        name, [=](const NumbersByName& n) {
          const std::string label = fmt::format("{} = {}", name, rough(n[name], 3));
          return Items{polygon(Role::edge, {first, u, v}, label), polyline(Role::edge, {first, u, v, first})};
        }};
  };
  setting.bindings = {part("D", triangle.a, triangle.b, triangle.c), part("α", q, triangle.b, triangle.c),
                      part("β", q, triangle.c, triangle.a), part("γ", q, triangle.a, triangle.b)};
  Stage stage = composed_stage(told, walk, setting);
  stage.steps.front().title = "Look at the triangle and the point";
  stage.method = "triangle::barycentric";
  stage.steps.push_back(parting_of_values(walk, setting, one.precision));
  const bool is_inside = std::none_of(values.begin(), values.end(),
                                      [](const WalkValue& v) { return v.name != "D" && v.value < 0; });
  stage.conclusion =
      fmt::format("{}: q = α·a + β·b + γ·c.", is_inside ? "None is negative, so the point is in the triangle"
                                                        : "One is negative, so the point is outside");
  return stage;
}

/// For each number of a run a bar of its digits: what is kept, and what is lost.
Stage digits_stage(const Case& one, const TellCase& tell) {
  const Told told = tell(one, "sphere/textbook");
  Setting setting = plot_setting(told);
  setting.slider.reset();
  setting.bindings.clear();
  const double digits = one.precision == Precision::float32 ? 24 : 53;
  std::size_t rows = 0;
  for (const WalkStep& step : told.walk->steps) rows += step.values.size();
  rows = std::max(rows, told.walk->inputs.size());
  const double row_height = 1.3 / static_cast<double>(rows);
  const auto x = [&](double bits) { return -0.7 + 1.7 * bits / digits; };
  for (const double bits : {0.0, digits / 4, digits / 2, 3 * digits / 4, digits}) {
    setting.scene.push_back(segment(Role::frame, {x(bits), -0.7, 0}, {x(bits), 0.68, 0}));
    setting.scene.push_back(point(Role::text, {x(bits), -0.75, 0}, rough(bits) + " bits"));
  }
  Stage stage = composed_stage(told, *told.walk, setting);
  // What the roots are on the ray has no place in this drawing.
  for (StageStep& step : stage.steps) step.items.clear();
  const auto add_bars = [&](StageStep& step, const std::vector<WalkValue>& values, std::size_t row) {
    for (const WalkValue& value : values) {
      const double y = 0.6 - row_height * static_cast<double>(row++);
      const double kept = std::max(0.0, digits - value.bits_lost);
      step.items.push_back(segment(Role::exact, {x(0), y, 0}, {x(kept), y, 0}));
      if (value.bits_lost >= 0.5)
        step.items.push_back(segment(Role::claimed, {x(kept), y, 0}, {x(digits), y, 0}, {}, Pattern::dotted));
      step.items.push_back(point(Role::text, {x(0) - 0.1, y, 0}, value.name));
    }
    return row;
  };
  (void)add_bars(stage.steps.front(), told.walk->inputs, 0);
  stage.steps.at(1).begins_anew = true;
  std::size_t row = 0;
  for (std::size_t i = 0; i < told.walk->steps.size(); ++i) {
    row = add_bars(stage.steps.at(i + 1), told.walk->steps[i].values, row);
  }
  stage.steps.front().title = "Every number begins with all its digits";
  stage.steps.push_back(parting_of_values(*told.walk, setting, one.precision));
  return stage;
}

}  // namespace

std::vector<Lesson> plot_lessons() {
  return {
      {"barycentric", "triangles", "Barycentric coordinates: three areas over the whole",
       "A point is the mean of the corners, weighed by the areas opposite them.",
       R"({"precision": "float32", "ray": {"origin": [0.3, 0.2, 2], "direction": [0, 0, -1]},
           "shape": {"type": "triangle", "a": [-1.3, -0.7, 0], "b": [1.6, -0.5, 0], "c": [0.2, 1.1, 0]}})",
       "", barycentric_stage},
      {"slab-intervals", "boxes", "Three slabs on the t axis",
       "Each pair of planes is an interval of t; the box is where all three overlap.",
       R"({"precision": "float32", "ray": {"origin": [-2.4, -1.7, 1.9], "direction": [0.9, 0.7, -0.4]},
           "shape": {"type": "box", "min": [-0.8, -0.6, 0.1], "max": [1.3, 0.9, 1.2]}})",
       "", intervals_stage},
      {"digits", "numbers", "Where the digits die",
       "Green is what is left of each number's digits. One subtraction takes nearly all of them.",
       R"({"precision": "float32", "ray": {"origin": [-250, 0.6, 0.3], "direction": [1.3, 0, 0]},
           "shape": {"type": "sphere", "center": [0, 0, 0], "radius": 0.7}})",
       "", digits_stage},
  };
}

}  // namespace rayproof::viz
