#pragma once
/// \file
/// What `rayproof walk` is to show: the lessons of a topic, or a case.

#include <string>
#include <vector>

#include "command_line/progress_line.hpp"
#include "viz/programs/report_case.hpp"
#include "viz/scene/stage.hpp"

namespace rayproof::viz {

/// A walkthrough and the group under which a gallery shows it.
struct Walk {
  std::string group;
  Stage stage;
};

/// The lessons of a topic, or the one case where `one` has a text. Throws as report_case does, and
/// WrongCommand for a topic that there is none of.
[[nodiscard]] std::vector<Walk> walks_for(const std::string& topic, const CaseOptions& one,
                                          ProgressLine& progress);

/// How much of a work of `all` parts is done, for a ProgressLine.
[[nodiscard]] inline double share(std::size_t done, std::size_t all) {
  return static_cast<double>(done) / static_cast<double>(all);
}

}  // namespace rayproof::viz
