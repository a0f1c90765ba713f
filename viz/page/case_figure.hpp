#pragma once
/// \file
/// A case as a figure of a page of many: a still picture that a script turns into a scene.

#include <string>

#include "viz/explain/case_report.hpp"

namespace rayproof::viz {

/// The case as an SVG for paper and for a page without script, and beside it the scene for shared_script(),
/// which shows thumbnails as they come into view and opens one scene at a time. The SVG alone where the
/// program has no three.js.
[[nodiscard]] std::string figure_of(const CaseReport& report);

/// The same of a finding, which may claim nothing; its exact answer must be given.
[[nodiscard]] std::string case_figure(const Case& one, const Answer* exact, const Answer* claimed);

/// The SVG of a finding, for a page or, behind xml_head, as a file.
[[nodiscard]] std::string case_still(const Case& one, const Answer* exact, const Answer* claimed);

/// What the scenes of a page need of its style.
[[nodiscard]] std::string scene_style();

/// The script of all pages.
[[nodiscard]] std::string shared_script();

/// Data for a script, with an id or without.
[[nodiscard]] std::string json_element(const std::string& id, const std::string& json);

}  // namespace rayproof::viz
