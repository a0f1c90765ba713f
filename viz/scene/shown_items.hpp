#pragma once
/// \file
/// What of a stage a step shows, and where its labels stand: the same for every sink.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "viz/picture/picture.hpp"
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

/// The role in whose colour its label is written: a surface's own colour would be lost before it, and a
/// frame's is too light to be read.
[[nodiscard]] constexpr Role label_role(const ShownItem& shown) {
  const Role role = shown_role(shown);
  return role == Role::surface ? Role::edge : role == Role::frame ? Role::muted : role;
}

/// An item's points as they are seen, in pixels: one of a point, the line of a line, the closed outline of a
/// surface.
using Outline = std::function<std::vector<Point>(const StageItem& item)>;

/// Writes the items' labels into a frame of a picture, beside what they name, so that none covers another, a
/// text that stands there, a mark or, where there is room, a line; nor what is taken already.
void draw_labels(Picture& picture, const PixelBox& frame, const std::vector<ShownItem>& shown,
                 const Outline& outline, const std::optional<PixelBox>& taken = {});

/// How much wider DejaVu Sans's bold letters are.
inline constexpr double bold_width = 1.12;

/// About how wide a line of DejaVu Sans is, rather more than less; combining marks have no width.
[[nodiscard]] double text_width(const std::string& text, double size, bool bold = false);

/// Where a text stands, from the top of its tallest letters to the bottom of its lowest.
[[nodiscard]] PixelBox box_of(const Text& text);

/// The text in lines of at most this many pixels, broken at spaces; a word too long for a line is broken in
/// two.
[[nodiscard]] std::vector<std::string> wrapped(const std::string& text, double width, double size);

}  // namespace rayproof::viz
