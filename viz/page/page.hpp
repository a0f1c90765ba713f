#pragma once
/// \file
/// Stages as pages: one HTML file each that needs nothing from elsewhere, and a gallery that links them. The
/// scene is drawn by three.js, the same that VTK draws on slides (viz/scene/space.hpp).

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "viz/explain/case_report.hpp"
#include "viz/scene/stage.hpp"

namespace rayproof::viz {

/// An element of HTML that shows a step's still picture: on paper, and where no script or no WebGL runs.
using Still = std::function<std::string(const Stage& stage, std::size_t step)>;

/// The still as SVG, without depth: for a build without VTK.
[[nodiscard]] std::string flat_still(const Stage& stage, std::size_t step);

/// What a page stands beside, and what stands above its steps; empty for nothing.
struct PageSurroundings {
  std::string gallery{};  ///< the gallery's address
  std::string script{};  ///< the address of a file with shared_script() (case_figure.hpp), which is otherwise
                         ///< in the page
  std::string figure{};  ///< an element of HTML; the conclusion then stands above it
  std::size_t first_step = 0;  ///< at which it opens, unless its address says another
};

/// A page. On a screen with script: one step at a time, a scene to orbit, and a slider along the ray. On
/// paper, or without script: all steps with a picture each.
[[nodiscard]] std::string stage_page(const Stage& stage, const Still& still = flat_still,
                                     const PageSurroundings& beside = {});

/// The page of a case: its stage, and above that all views of it in one figure (case_figure.hpp).
[[nodiscard]] std::string case_page(const CaseReport& report, const std::string& script = {});

/// What a gallery shows of a stage.
struct GalleryEntry {
  std::string group;
  std::string file;
  const Stage* stage;
};

/// One page with a picture of each stage under its group's name, in the given order.
[[nodiscard]] std::string gallery_page(const std::vector<GalleryEntry>& entries,
                                       const Still& still = flat_still);

/// Title, picture, words, typeset equations, what became of the digits, and a table of the numbers.
[[nodiscard]] std::string step_section(const Stage& stage, std::size_t number, const Still& still);

}  // namespace rayproof::viz
