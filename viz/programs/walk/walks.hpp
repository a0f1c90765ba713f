#pragma once
/// \file
/// What `rayproof walk` shows, the lessons of a topic or a case; and what it shows by VTK.

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "case/print_to_stderr.hpp"
#include "case/reader/near_names.hpp"
#include "command_line/interrupt.hpp"
#include "command_line/progress_line.hpp"
#include "viz/programs/files.hpp"
#include "viz/programs/plays_of.hpp"
#include "viz/programs/report_case.hpp"
#include "viz/programs/report_of.hpp"
#include "viz/scene/film.hpp"
#include "viz/scene/stage.hpp"
#include "viz/walkthrough/lesson.hpp"

#ifdef RAYPROOF_HAS_VTK
#include "viz/vtk/offscreen_display.hpp"
#include "viz/vtk/picture_png.hpp"
#include "viz/vtk/window/stage_window.hpp"
#endif

namespace rayproof::viz {

/// A walkthrough and the group under which a gallery shows it.
struct Walk {
  std::string group;
  Stage stage;
};

/// How much of a work of `all` parts is done, for a ProgressLine.
[[nodiscard]] inline double share(std::size_t done, std::size_t all) {
  return static_cast<double>(done) / static_cast<double>(all);
}

/// The report on the case with its method; without one, or its answer, by the first sound one of its topic
/// whose steps can be recorded.
[[nodiscard]] inline CaseReport report_for(const CaseOptions& options) {
  const CaseReport report = report_case(options);
  if (report.claimed) return report;
  for (const Subject& subject : subjects()) {
    if (subject.topic != topic_of(report.one) || subject.contract.standing != Standing::sound) continue;
    if (!recorded_walk(report.one, subject.name)) continue;
    print_to_stderr(
        "rayproof walk: {} (the first sound method whose steps can be recorded; --method chooses)\n",
        subject.full_name());
    return report_of(report.one, &subject);
  }
  print_to_stderr(
      "rayproof walk: the exact answer alone (no {} method's steps can be recorded; --method chooses)\n",
      topic_of(report.one));
  return report;
}

/// Why a topic has no lessons.
[[nodiscard]] inline std::string no_topic(const std::string& topic) {
  std::vector<std::string> names;
  for (const Lesson& lesson : lessons()) {
    names.push_back(lesson.name);
    if (std::ranges::find(names, lesson.group) == names.end()) names.push_back(lesson.group);
  }
  const auto meant = likely_name(topic, names);
  return fmt::format("there is no topic '{}'; {}", topic,
                     meant ? fmt::format("did you mean {}?", *meant) : "rayproof walk --list names them");
}

/// The lessons of a topic, or the one case where `one` has a text. Throws as report_case does, and
/// WrongCommand for a topic that there is none of.
[[nodiscard]] inline std::vector<Walk> walks_for(const std::string& topic, const CaseOptions& one,
                                                 ProgressLine& progress) {
  if (!one.text.empty()) return {{"Cases", stage_of(report_for(one))}};
  const auto found = lessons_of(topic);
  if (topic.empty()) throw WrongCommand("which walkthrough? Give a topic, --case or --list");
  if (found.empty()) throw WrongCommand(no_topic(topic));
  std::vector<Walk> walks;
  for (const Lesson* lesson : found) {
    progress.show(share(walks.size(), found.size()), lesson->name + " is computed");
    walks.push_back({lesson->group, stage_of(*lesson, [](const Case& asked, const std::string& method) {
                       return report_of(asked, method);
                     })});
  }
  return walks;
}

#ifdef RAYPROOF_HAS_VTK
/// Writes a PNG for each step and a contact sheet of each walkthrough. Throws WrongCommand where the folder
/// can't be made or there is no VTK, std::runtime_error with one sentence where a file can't be written.
inline void write_pngs(const std::vector<Walk>& walks, const std::string& folder, ProgressLine& progress) {
  if (folder.ends_with(".png"))
    throw WrongCommand("--png writes a picture for each step into a folder: " + folder +
                       " names one picture");
  keep_on_interrupt();  // the picture under way is drawn
  const OffscreenDisplay display;
  PictureCanvas canvas;
  make_folder(folder);
  std::size_t all = 0;
  for (const Walk& walk : walks) all += walk.stage.steps.size();
  std::size_t done = 0;
  const auto path = [&](const std::string& name) { return fmt::format("{}/{}.png", folder, name); };
  for (const auto& [group, stage] : walks) {
    std::vector<Raster> slides;
    for (std::size_t i = 0; i < stage.steps.size(); ++i) {
      if (is_interrupted) {
        progress.clear();
        return print_to_stderr("rayproof walk: interrupted: {} of {} pictures are written\n", done, all);
      }
      const std::string name = fmt::format("{}-{}", stage.name, i + 1);
      progress.show(share(done++, all), fmt::format("picture {}.png", name));
      slides.push_back(draw_slide(canvas, stage, i));
      write_png(slides.back(), path(name));
    }
    write_png(contact_sheet(slides), path(stage.name));
  }
}

/// Writes a film of all walkthroughs, one after another; after Ctrl-C there is none, and a file of that name
/// is as it was. Throws WrongCommand for a name that is not of such a film or where there is no VTK,
/// std::runtime_error with one sentence where the file can't be written.
inline void write_movie(const std::vector<Walk>& walks, const std::string& path, ProgressLine& progress) {
  if (!path.ends_with(".ogv")) throw WrongCommand("--movie writes Ogg video: " + path + " must end in .ogv");
  keep_on_interrupt();  // the picture under way is drawn, and no file is left
  PartialFile file(path);
  std::size_t all = 0;
  for (const Walk& walk : walks) all += shots_of(walk.stage).size();
  std::size_t done = 0;
  {
    const OffscreenDisplay display;
    PictureCanvas canvas;
    Movie movie(file.path(), film_rate);
    for (const auto& [group, stage] : walks) {
      for (const Shot& shot : shots_of(stage)) {
        if (is_interrupted) {
          progress.clear();
          return print_to_stderr("rayproof walk: interrupted: no film is left\n");
        }
        progress.show(share(done++, all), fmt::format("film of {}, step {}", stage.name, shot.step + 1));
        movie.add(draw_slide(canvas, stage_at(stage, shot), shot.step, 1280, shot.count > 1), shot.count);
      }
    }
  }
  file.keep();
}

/// Shows the stage of one case, or else the lessons of a topic; returns when the user quits. Throws
/// std::runtime_error with one sentence where there is no display to show a window, or no VTK to make one.
inline void show_window(const std::optional<Stage>& one, const std::string& topic) {
  const UserDisplay display;
  Player player(one ? plays_of(*one) : plays_of(topic));
  StageWindow window(player);
  window.run();
}
#else
inline void write_pngs(const std::vector<Walk>& /*walks*/, const std::string& folder,
                       ProgressLine& /*progress*/) {
  throw WrongCommand("--png " + folder + " needs VTK, which this build was made without; --html works");
}

inline void write_movie(const std::vector<Walk>& /*walks*/, const std::string& path,
                        ProgressLine& /*progress*/) {
  throw WrongCommand("--movie " + path + " needs VTK, which this build was made without; --html works");
}

inline void show_window(const std::optional<Stage>& /*one*/, const std::string& /*topic*/) {
  throw std::runtime_error("--window needs VTK, which this build was made without; --html works");
}
#endif

}  // namespace rayproof::viz
