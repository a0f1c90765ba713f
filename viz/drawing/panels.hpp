#pragma once
/// \file
/// How every topic's picture is laid out: a headline, one frame or two side by side, a table of the answers.

#include <string>
#include <utility>

#include "case/answer.hpp"
#include "case/case.hpp"
#include "viz/drawing/view.hpp"

namespace rayproof::viz {

/// The frames: one of full width, or the whole at the left and a magnified part at the right.
struct Panels {
  PixelBox whole{20, 108, 860, 280};
  PixelBox left{20, 108, 420, 280};
  PixelBox right{460, 108, 420, 280};
};

/// A picture with its headline and a line on the geometry.
[[nodiscard]] Picture begin_picture(const std::string& what, const Case& one, const std::string& headline,
                                    const std::string& geometry);

/// "Magnified 3e7 times", or how much along and across.
[[nodiscard]] std::string magnification(const View& main, const View& inset);

/// A square in the main view around what the inset shows.
void draw_focus(Picture& picture, const View& main, const View& inset);

/// A labelled length between two points on one horizontal or vertical line.
void draw_measure(Picture& picture, const View& view, const std::pair<WorldPoint, WorldPoint>& ends,
                  const std::string& label);

/// The table of answers, the note, and the picture's height.
void finish_picture(Picture& picture, const Panels& panels, const std::string& symbol, const Case& one,
                    const Answer* exact, const Answer* claimed);

}  // namespace rayproof::viz
