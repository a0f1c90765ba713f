#pragma once
/// \file
/// What `rayproof walk` is to show: the lessons of a topic, or a case.

#include <optional>
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

/// Writes a PNG for each step and a contact sheet of each walkthrough. Throws WrongCommand where the folder
/// can't be made or there is no VTK, std::runtime_error with one sentence where a file can't be written.
void write_pngs(const std::vector<Walk>& walks, const std::string& folder, ProgressLine& progress);

/// Writes a film of all walkthroughs, one after another; after Ctrl-C there is none, and a file of that name
/// is as it was. Throws WrongCommand for a name that is not of such a film or where there is no VTK,
/// std::runtime_error with one sentence where the file can't be written.
void write_movie(const std::vector<Walk>& walks, const std::string& path, ProgressLine& progress);

/// Shows the stage of one case, or else the lessons of a topic; returns when the user quits. Throws
/// std::runtime_error with one sentence where there is no display to show a window, or no VTK to make one.
void show_window(const std::optional<Stage>& one, const std::string& topic);

}  // namespace rayproof::viz
