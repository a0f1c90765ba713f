#include "viz/scene/shown_items.hpp"

namespace rayproof::viz {

std::vector<ShownItem> shown_in(const Stage& stage, std::size_t step) {
  std::vector<ShownItem> shown;
  const bool is_apart = stage.steps[step].is_apart;
  if (!is_apart) {
    for (const StageItem& item : stage.scene) shown.push_back({&item, Emphasis::scene});
    std::size_t first = step;
    while (first > 0 && !stage.steps[first].begins_anew) --first;
    for (std::size_t before = first; before < step; ++before) {
      if (stage.steps[before].is_apart) continue;
      for (const StageItem& item : stage.steps[before].items) shown.push_back({&item, Emphasis::dimmed});
    }
  }
  for (const StageItem& item : stage.steps[step].items) shown.push_back({&item, Emphasis::bright});
  return shown;
}

}  // namespace rayproof::viz
