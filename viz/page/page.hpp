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
#include "viz/trace/expression.hpp"

namespace rayproof::viz {

/// An element of HTML that shows a step's still picture: on paper, and where no script or no WebGL runs.
using Still = std::function<std::string(const Stage& stage, std::size_t step)>;

/// The still as SVG, without depth: for a build without VTK.
[[nodiscard]] std::string flat_still(const Stage& stage, std::size_t step);

/// What a page stands beside, and what stands above its steps; empty for nothing.
struct PageSurroundings {
  std::string gallery{};       ///< the gallery's address
  std::string script{};        ///< the address of a file with shared_script(), which is otherwise in the page
  std::string figure{};        ///< an element of HTML; the conclusion then stands above it
  std::size_t first_step = 0;  ///< at which it opens, unless its address says another
};

/// A page. On a screen with script: one step at a time, a scene to orbit, and a slider along the ray. On
/// paper, or without script: all steps with a picture each.
[[nodiscard]] std::string stage_page(const Stage& stage, const Still& still = flat_still,
                                     const PageSurroundings& beside = {});

/// The page of a case: its stage, and above that all views of it in one figure.
[[nodiscard]] std::string case_page(const CaseReport& report, const std::string& script = {});

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

/// The case as an SVG for paper and for a page without script, and beside it the scene for shared_script(),
/// which shows thumbnails as they come into view and opens one scene at a time. The SVG alone where the
/// program has no three.js.
[[nodiscard]] std::string figure_of(const CaseReport& report);

/// The same of a finding, which may claim nothing; its exact answer must be given.
[[nodiscard]] std::string case_figure(const Case& one, const Answer* exact, const Answer* claimed);

/// The SVG of a finding, for a page or, behind xml_head, as a file.
[[nodiscard]] std::string case_still(const Case& one, const Answer* exact, const Answer* claimed);
[[nodiscard]] std::string scene_style();
[[nodiscard]] std::string shared_script();

/// One line. Numbers are JSON numbers that read back as the same double, or the case format's strings for
/// what is not finite; each value also bears its `shown` decimal, the shortest that reads back in the
/// precision.
[[nodiscard]] std::string stage_json(const Stage& stage);

/// Of each step the camera, the bodies, the labels as HTML, the floor, and the slider's ray, all in the
/// coordinates of the step's view, to 4 decimals (a hundredth of a pixel); see viz/scene/space.hpp.
[[nodiscard]] std::string space_json(const Stage& stage);

/// A text for a reader: typeset, its markup escaped.
[[nodiscard]] std::string html_text(const std::string& text);

/// A `<math>` element: quotients are fractions, "t₀" and "S_x" get subscripts.
[[nodiscard]] std::string math_ml(const Formula& formula);

}  // namespace rayproof::viz
