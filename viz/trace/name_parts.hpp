#pragma once
/// \file
/// The names in formulas, taken apart: letters and index.

#include <string>

namespace rayproof::viz {

/// A name of one thing, as it is typeset.
struct NameParts {
  std::string letters;  ///< "t" of "t₀", "S" of "S_x"
  std::string index{};  ///< "0" of "t₀", "x" of "S_x" and of "f.x", "1x" of "e₁.x"
};

[[nodiscard]] NameParts parts_of_name(std::string name);

/// "f" of "f.x" and 'x': the vector whose component of that axis has this name; empty where it is none.
[[nodiscard]] std::string vector_of(const std::string& name, char axis);

/// The same for any axis; else the name itself.
[[nodiscard]] std::string without_axis(const std::string& name);

}  // namespace rayproof::viz
