#include "viz/scene/fit_view.hpp"
#include "viz/walkthrough/compose.hpp"

namespace rayproof::viz {

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
  all.insert(all.end(), step.items.begin(), step.items.end());
  step.view = seen_of(all);
  stage.steps.at(number + 1).begins_anew = true;
}

}  // namespace rayproof::viz
