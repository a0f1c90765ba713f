#include "viz/walkthrough/lessons/surface_setting.hpp"

#include "viz/scene/fit_view.hpp"

namespace rayproof::viz {

Setting surface_setting(const CaseReport& report, Items surface, double t_end) {
  Setting setting = setting_of(report);
  const Ray<double>& ray = std::get<RayQuestion>(report.one.question).ray;
  setting.scene = std::move(surface);
  setting.scene.push_back(arrow(Role::ray, ray.origin, ray.origin + t_end * ray.direction, "p(t)"));
  setting.scene.push_back(point(Role::ray, ray.origin, "o"));
  setting.near = setting.wide = view_of(extent_of(setting.scene, setting.camera), setting.camera);
  setting.spaces.clear();
  setting.slider->from = 0;
  setting.slider->to = t_end;
  setting.slider->readouts.clear();
  return setting;
}

void begin_anew(Stage& stage, std::string_view title) {
  for (StageStep& step : stage.steps)
    if (step.title.starts_with(title)) step.begins_anew = true;
}

}  // namespace rayproof::viz
