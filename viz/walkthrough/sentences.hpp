#pragma once
/// \file
/// What a step says, taken apart.

#include <string>
#include <vector>

namespace rayproof::viz {

/// "p is a point. t is its place." as two.
[[nodiscard]] std::vector<std::string> sentences_of(const std::string& text);

/// Whether a sentence speaks of a number of that name. "a" is an article, too, and never counts.
[[nodiscard]] bool mentions(const std::string& sentence, const std::string& name);

/// How many letters a text has; combining marks are none.
[[nodiscard]] std::size_t letters_of(const std::string& text);

}  // namespace rayproof::viz
