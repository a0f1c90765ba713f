#pragma once
/// \file
/// Stages as pages: one HTML file each that needs nothing from elsewhere, and a gallery that links them.

#include <string>
#include <vector>

#include "viz/scene/stage.hpp"

namespace rayproof::viz {

/// A self-contained page. On a screen with script: one step at a time, a scene to orbit, and a slider along
/// the ray. On paper, or without script: all steps with a picture each. `gallery` is the address of the
/// gallery, or empty for no link.
[[nodiscard]] std::string stage_page(const Stage& stage, const std::string& gallery = {});

/// What a gallery shows of a stage.
struct GalleryEntry {
  std::string group;
  std::string file;
  const Stage* stage;
};

/// One page with a picture of each stage under its group's name, in the given order.
[[nodiscard]] std::string gallery_page(const std::vector<GalleryEntry>& entries);

}  // namespace rayproof::viz
