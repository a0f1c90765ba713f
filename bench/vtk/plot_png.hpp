#pragma once
/// \file
/// The plots as PNG files, drawn by VTK's charts.

#include <filesystem>
#include <string>
#include <vector>

#include "bench/page/plot.hpp"

namespace rayproof::report {

/// Writes DIR/pareto-SHAPE.png for each plot. Returns lines for the user: what was written, or, in one plain
/// line, why there are no PNG files.
#ifdef RAYPROOF_VTK
[[nodiscard]] std::vector<std::string> write_pngs(const std::vector<Plot>& plots,
                                                  const std::filesystem::path& folder);
#else
[[nodiscard]] inline std::vector<std::string> write_pngs(const std::vector<Plot>& /*plots*/,
                                                         const std::filesystem::path& /*folder*/) {
  return {"no PNG plots: this program was built without VTK"};
}
#endif

}  // namespace rayproof::report
