#pragma once
/// \file
/// The column of numbers at the right of a slide's scene.

#include "viz/flat/stage_picture.hpp"

namespace rayproof::viz {

/// Below each name of the step the rounded number, the exact one, and the bits lost where they are worth a
/// word; as high as the scene.
void draw_values(Picture& picture, const Stage& stage, const StageStep& step, const PixelBox& scene);

/// The text's first line of that width, and "…" where there are more.
[[nodiscard]] std::string cut(const std::string& text, double width, double size);

}  // namespace rayproof::viz
