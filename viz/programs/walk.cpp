/// \file
/// rayproof walk: a ray meets a shape, step by step, to the last digit.

#include <filesystem>
#include <fstream>

#include "viz/programs/tell_case.hpp"
#include "viz/stage/lesson.hpp"
#include "viz/stage/stage_json.hpp"
#include "viz/stage/stage_of.hpp"
#include "viz/stage/stage_picture.hpp"
#ifdef RAYPROOF_HAS_VTK
#include "viz/vtk/offscreen_display.hpp"
#include "viz/vtk/picture_png.hpp"
#endif

namespace {

using namespace rayproof;

struct Options {
  std::string topic{};
  viz::CaseOptions one{};
  std::string png{};
  bool is_list = false;
  bool is_json = false;
};

std::vector<viz::Stage> stages_for(const Options& options) {
  if (!options.one.text.empty()) return {viz::stage_of(viz::tell_case(options.one))};
  const auto found = viz::lessons_of(options.topic);
  if (found.empty())
    throw viz::WrongCommand("there is no topic " + options.topic + "; see rayproof walk --list");
  std::vector<viz::Stage> stages;
  for (const viz::Lesson* lesson : found) {
    stages.push_back(viz::stage_of(
        *lesson, [](const Case& one, const std::string& method) { return viz::told_of(one, method); }));
  }
  return stages;
}

void write_pngs(const std::vector<viz::Stage>& stages, const std::string& folder) {
#ifdef RAYPROOF_HAS_VTK
  const viz::OffscreenDisplay display;
  std::filesystem::create_directories(folder);
  for (const viz::Stage& stage : stages) {
    for (std::size_t i = 0; i < stage.steps.size(); ++i) {
      viz::write_picture(viz::slide_picture(stage, i),
                         fmt::format("{}/{}-{}.png", folder, stage.name, i + 1));
    }
    viz::write_picture(viz::contact_sheet(stage), fmt::format("{}/{}.png", folder, stage.name), 2.0 / 3);
  }
#else
  (void)stages;
  throw viz::WrongCommand("--png " + folder + " needs VTK, which this build was made without; --html works");
#endif
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Shows a ray meeting a shape, step by step, to the last digit.", "rayproof walk");
  Options options;
  app.add_option("TOPIC", options.topic, "A topic of --list, a group of them, or all");
  app.add_option("--case", options.one.text,
                 "Any case: a file, -, the case as JSON, or a finding of rayproof check");
  app.add_option("--line", options.one.line, "Which line of the file, from 1")->check(CLI::PositiveNumber);
  app.add_option("--method", options.one.method, "The method for --case; a finding brings its own")
      ->type_name("SHAPE/METHOD");
  app.add_option("--precision", options.one.precision, "Round the case to this in place of its own precision")
      ->check(CLI::IsMember({"float32", "float64"}));
  app.add_option("--png", options.png, "Write a PNG for each step and a contact sheet, drawn by VTK")
      ->type_name("DIR");
  app.add_flag("--json", options.is_json, "Print the data of each walkthrough as a line of JSON");
  app.add_flag("--list", options.is_list, "List the topics");
  app.footer("Exit status: 0 done, 1 the case is refused, 2 wrong command line.");
  if (const auto status = parse_command_line(app, argc, argv)) return *status;

  return viz::run_and_report("rayproof walk", [&] {
    if (options.is_list) {
      for (const viz::Lesson& lesson : viz::lessons()) fmt::print("{:<28}{}\n", lesson.name, lesson.title);
      return;
    }
    const auto stages = stages_for(options);
    if (options.is_json) {
      for (const viz::Stage& stage : stages) fmt::print("{}\n", viz::stage_json(stage));
    }
    if (!options.png.empty()) write_pngs(stages, options.png);
  });
}
