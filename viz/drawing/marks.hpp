#pragma once
/// \file
/// The answers' points in a picture: where they lie, and their names beside them.

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "case/answer.hpp"
#include "viz/drawing/view.hpp"

namespace rayproof::viz {

/// A finite t or x of an answer.
struct NamedMark {
  Role role = Role::exact;
  std::string label;  ///< "t₀"
  WorldPoint at;
};

/// The marks of both answers; `place` puts a value into the scene.
[[nodiscard]] std::vector<NamedMark> marks_of(const std::string& symbol, const Answer* exact,
                                              const Answer* claimed,
                                              const std::function<WorldPoint(double)>& place);

/// The exact value and the claimed one of the same rank that lie farthest apart in digits; nothing where all
/// agree.
[[nodiscard]] std::optional<std::pair<WorldPoint, WorldPoint>> worst_pair(
    const Answer* exact, const Answer* claimed, const std::function<WorldPoint(double)>& place);

/// Rings for exact and crosses for claimed values, the names of exact ones above, of claimed ones below;
/// names that would overlap are joined.
void draw_marks(Picture& picture, const View& view, const std::vector<NamedMark>& marks);

/// Arrows at the frame's sides toward the claimed values outside it, at the height of y = 0.
void draw_marks_beyond(Picture& picture, const View& view, const std::vector<NamedMark>& marks);

}  // namespace rayproof::viz
