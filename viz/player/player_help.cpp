#include "viz/player/player.hpp"

#include <array>

namespace rayproof::viz {
namespace {

struct Help {
  const char* keys;
  const char* what;
};

constexpr std::array help{
    Help{"← →  Page up, Page down", "the step before, the next"},
    Help{"Home  End  1 … 9", "the first step, the last, that one"},
    Help{"↑ ↓  + −", "move the point along the ray; or drag the slider"},
    Help{",  .  [  ]", "to the neighbouring number: the smallest change of t there is"},
    Help{"Tab", "what the arrow keys move: the steps, the slider, the view, then each handle"},
    Help{"Drag a ball",
         "moves the ray's origin or its tip, or what defines the shape; all is computed again"},
    Help{"Drag elsewhere",
         "looks from another side, as does a click on an axis of the compass; with Shift it shifts"},
    Help{"Wheel", "nearer, farther; + − while the arrow keys move the view"},
    Help{"r", "everything as it was at first"},
    Help{"c", "print the case as it stands, for any program that reads cases"},
    Help{"s", "save the window's picture as a PNG, where the program was started"},
    Help{"n  p", "the next walkthrough, the one before, where there are several"},
    Help{"h  F1  ?", "this page; Esc closes it"},
    Help{"q", "quit"},
};

}  // namespace

Picture help_picture(const Stage& stage) {
  constexpr double column = 260;
  Picture picture{slide_width, slide_height, stage.title, "What the keys and the mouse do."};
  add_text(picture, Role::text, {slide_margin, 44}, "What the keys and the mouse do", 22, true);
  double y = 80;
  for (const Help& one : help) {
    add_text(picture, Role::text, {slide_margin, y}, one.keys, 14, true);
    add_text(picture, Role::text, {column, y}, one.what, 14, false);
    y += 28;
  }
  add_text(
      picture, Role::muted, {slide_margin, y + 8},
      "The numbers are the run's own: each drag makes a case and runs the method and the exact answer on "
      "it again.",
      13, false);
  return picture;
}

}  // namespace rayproof::viz
