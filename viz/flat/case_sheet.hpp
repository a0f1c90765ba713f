#pragma once
/// \file
/// The picture of a case: what is asked, the truth, and what the code said, at a glance.

#include <vector>

#include "viz/explain/case_report.hpp"
#include "viz/picture/picture.hpp"
#include "viz/scene/stage.hpp"

namespace rayproof::viz {

/// All but the scenes: a headline, a frame for each view, and a table of the answers below them.
struct CaseSheet {
  Stage stage{};                   ///< its steps are the views (viz/walkthrough/case_views.hpp)
  std::vector<PixelBox> frames{};  ///< where each is to be drawn
  Picture picture{};
};
[[nodiscard]] CaseSheet case_sheet(const CaseReport& report);

/// The same with the scenes drawn flat, each with a scale: what SVG shows. Never throws for a valid case,
/// whatever the answers' numbers.
[[nodiscard]] Picture case_picture(const CaseReport& report);

}  // namespace rayproof::viz
