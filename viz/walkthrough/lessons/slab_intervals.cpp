#include <algorithm>
#include <cmath>
#include <rayproof/box/slab.hpp>

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

Stage intervals_stage(const Case& one, const ReportCase& report_on) {
  const CaseReport report = report_on(one, "box/slabs");
  const auto& question = std::get<RayQuestion>(one.question);
  const Walkthrough walk =
      record(one.precision, [&]<class R>(std::type_identity<R>) { narrate_slabs<R>(question); });
  Setting setting = plot_setting(report);
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
  setting.slider.reset();
  Stage stage = composed_stage(report, walk, setting);
  stage.steps.front().title = "Measure the ray by its t axis";
  stage.method = "box/slabs";
  stage.steps.push_back(difference_of_values(walk, setting, one.precision));
  stage.conclusion = "A box is where three intervals overlap.";
  return stage;
}

}  // namespace rayproof::viz
