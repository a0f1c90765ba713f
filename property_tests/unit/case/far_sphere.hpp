#pragma once
/// \file
/// The case that the reader's tests change one thing of.

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace rayproof {

/// Every field of the format, in float32.
inline constexpr std::string_view far_sphere =
    R"({"id": 7, "precision": "float32", "ray": {"origin": [0,0,-5], "direction": [0,0,"0x1p+0"], "t_min": 0.1, "t_max": "inf"}, )"
    R"("shape": {"type": "sphere", "center": [0.1,"2",3e0], "radius": 1}, )"
    R"("transform": [[2,0,0,7],[0,1,0,8],[0,0,1,9],[0,0,0,1]], "note": "caf\u00e9"})";

/// `text` with its first `from` replaced by `to`.
inline std::string replaced(std::string_view text, std::string_view from, std::string_view to) {
  std::string changed(text);
  const std::size_t at = changed.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return changed.replace(at, from.size(), to);
}

}  // namespace rayproof
