#pragma once
/// \file
/// What of a stage a step shows: the same for every sink.

#include <vector>

#include "viz/scene/stage.hpp"

namespace rayproof::viz {

/// How an item is drawn: of the step itself, of a step before, or of the scene.
enum class Emphasis { scene, dimmed, bright };

struct ShownItem {
  const StageItem* item;
  Emphasis emphasis;
};

/// In the order of painting: the scene, what was, what is new. They live as long as the stage.
[[nodiscard]] std::vector<ShownItem> shown_in(const Stage& stage, std::size_t step);

/// The colour's role: what is dimmed is grey.
[[nodiscard]] constexpr Role shown_role(const ShownItem& shown) {
  return shown.emphasis == Emphasis::dimmed ? Role::muted : shown.item->role;
}

/// The role in whose colour its label is written: a surface's own colour would be lost before it.
[[nodiscard]] constexpr Role label_role(const ShownItem& shown) {
  const Role role = shown_role(shown);
  return role == Role::surface ? Role::edge : role;
}

}  // namespace rayproof::viz
