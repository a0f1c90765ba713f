#pragma once
/// \file
/// A line of text with lowered indices, which Unicode has for some letters only: "t_c", "S_y".

#include <string>
#include <vector>

namespace rayproof::viz {

/// A part of a line that stands on one height.
struct TextRun {
  std::string text;
  bool is_low = false;  ///< an index: smaller, and below the baseline
};
/// In em of the line's text: an index's size, and how far its baseline lies below the line's.
inline constexpr double low_size = 0.72;
inline constexpr double low_drop = 0.16;

/// The runs of a line: letters and digits that follow a letter and "_" are an index, without the "_".
[[nodiscard]] std::vector<TextRun> runs_of(const std::string& line);

}  // namespace rayproof::viz
