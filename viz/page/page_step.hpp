#pragma once
/// \file
/// A step of a stage's page, as it stands there without script and on paper.

#include <cstddef>
#include <string>

#include "viz/scene/stage.hpp"

namespace rayproof::viz {

/// The size of a page's scene, in its own pixels.
inline constexpr double page_scene_width = 640, page_scene_height = 430;

/// Title, picture, words, typeset equations, what became of the digits, and a table of the numbers.
[[nodiscard]] std::string step_section(const Stage& stage, std::size_t number);

}  // namespace rayproof::viz
