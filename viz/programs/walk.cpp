/// \file
/// rayproof walk: a ray meets a shape, step by step, to the last digit.

#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <utility>

#include "command_line/interrupt.hpp"
#include "command_line/progress_line.hpp"
#include "viz/page/page.hpp"
#include "viz/programs/files.hpp"
#include "viz/programs/walk/walks.hpp"
#include "viz/walkthrough/lesson.hpp"
#ifdef RAYPROOF_HAS_VTK
#include "viz/vtk/offscreen_display.hpp"
#include "viz/vtk/picture_png.hpp"
#endif

namespace {

using namespace rayproof;

struct WalkOptions {
  std::string topic{};
  viz::CaseOptions one{};
  std::string png{};
  std::string html{};
  std::string movie{};
  bool is_window = false;
  bool is_list = false;
  bool is_json = false;
};

/// The still pictures of pages: by VTK, and flat without it or without a display for it.
class Stills {
 public:
#ifdef RAYPROOF_HAS_VTK
  Stills() {
    try {
      display_.emplace();
      canvas_.emplace();
    } catch (const std::runtime_error&) {
      canvas_.reset();
    }
  }
  [[nodiscard]] std::string operator()(const viz::Stage& stage, std::size_t step) {
    return canvas_ ? viz::still_of(*canvas_, stage, step) : viz::flat_still(stage, step);
  }

 private:
  std::optional<viz::OffscreenDisplay> display_{};
  std::optional<viz::PictureCanvas> canvas_{};
#else
  [[nodiscard]] std::string operator()(const viz::Stage& stage, std::size_t step) {
    return viz::flat_still(stage, step);
  }
#endif
};

/// A page for each walkthrough and a gallery of them. The script goes first, so that none is without it;
/// after Ctrl-C the gallery shows those that were written.
void write_gallery(const std::vector<viz::Walk>& walks, const std::filesystem::path& folder,
                   const viz::Still& still, ProgressLine& progress) {
  make_folder(folder);
  write_file(folder / "walkthrough.js", viz::shared_script());
  std::vector<viz::GalleryEntry> gallery;
  for (const auto& [group, stage] : walks) {
    if (is_interrupted) break;
    const std::string file = stage.name + ".html";
    progress.show(viz::share(gallery.size(), walks.size()), "page " + file);
    write_file(folder / file, viz::stage_page(stage, still, {"index.html", "walkthrough.js"}));
    gallery.push_back({group, file, &stage});
  }
  write_file(folder / "index.html", viz::gallery_page(gallery, still));
  progress.clear();
  if (gallery.size() < walks.size())
    print_to_stderr("rayproof walk: interrupted: {} of {} pages are written, and {} shows those\n",
                    gallery.size(), walks.size(), (folder / "index.html").string());
}

/// One page where the path is that of a page; else a folder of pages with a gallery. That of a finding opens
/// where the answer was spoilt.
void write_pages(const std::vector<viz::Walk>& walks, const std::string& path, bool is_finding,
                 ProgressLine& progress) {
  const bool is_page = path.ends_with(".html");
  if (is_page && walks.size() > 1)
    throw viz::WrongCommand(
        fmt::format("--html {} is one page, for {} walkthroughs: name a folder", path, walks.size()));
  keep_on_interrupt();
  Stills stills;
  const viz::Still still = std::ref(stills);
  if (!is_page) return write_gallery(walks, path, still, progress);
  const viz::Stage& stage = walks.front().stage;
  const std::size_t first = is_finding ? stage.decisive_step : 0;
  write_file(path, viz::stage_page(stage, still, {.first_step = first}));
}

/// What TOPIC may be: all, a group of topics, or a topic, each topic below its group.
void print_topics() {
  fmt::print("{:<26}{}\n", "all", "Every topic");
  std::string group;
  for (const viz::Lesson& lesson : viz::lessons()) {
    if (lesson.group != group) fmt::print("{:<26}All of these:\n", lesson.group);
    group = lesson.group;
    fmt::print("  {:<24}{}\n", lesson.name, lesson.title);
  }
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine app("Shows a ray meeting a shape, step by step, to the last digit.", "rayproof walk");
  WalkOptions options;
  app.add_option("TOPIC", options.topic,
                 "A topic of --list, a group of them, or all; or the number of a finding of rayproof check");
  auto* const one =
      app.add_option("--case", options.one.text, "Any case: a file, -, or one case or finding as JSON");
  for (CLI::Option* const choice : options.one.add_choices_to(
           app,
           "The method for --case; a finding brings its own, any other case takes a sound one of its topic"))
    choice->needs(one);
  app.add_option("--png", options.png, "Write a PNG for each step and a contact sheet, drawn by VTK")
      ->type_name("DIR");
  app.add_option(
         "--html", options.html,
         "Write a page for each walkthrough, and a gallery of them; for the number of a finding without "
         "any output, walk-N.html beside the findings")
      ->type_name("DIR or FILE.html");
  app.add_option("--movie", options.movie,
                 "Write a film of it by VTK: the ray travels, t runs, hits light up, step after step")
      ->type_name("FILE.ogv");
  app.add_flag("--window", options.is_window,
               "Show it in a window: steps by key, t by a slider, the ray by dragging");
  app.add_flag("--json", options.is_json, "Print the data of each walkthrough as a line of JSON");
  app.add_flag("--list", options.is_list, "List the topics and their groups");
  app.footer("Exit status: 0 done, 1 the case is refused, 2 wrong command line, 130 interrupted.");
  if (const auto status = parse_command_line(app, argc, argv)) return *status;

  const int status = viz::run_and_report("rayproof walk", [&] {
    if (options.is_list) {
      refuse_all_options_but(app, {"--list"}, "--list prints the topics alone");
      return print_topics();
    }
    if (!options.topic.empty() && !options.one.text.empty())
      throw viz::WrongCommand("give a topic or --case, not both");
    if (finding_number(options.topic)) options.one.text = std::exchange(options.topic, "");
    options.one.refuse_idle();
    const bool has_output =
        options.is_json || options.is_window || !(options.html + options.png + options.movie).empty();
    if (!has_output) options.html = viz::page_beside_findings(options.one, "walk");
    ProgressLine progress;
    const auto walks = viz::walks_for(options.topic, options.one, progress);
    progress.clear();
    if (!has_output && options.html.empty())
      throw viz::WrongCommand("nothing to do: give --html, --png, --movie, --json or --window");
    if (options.is_json) {
      for (const viz::Walk& walk : walks) fmt::print("{}\n", viz::stage_json(walk.stage));
    }
    if (!options.html.empty()) write_pages(walks, options.html, !has_output, progress);
    if (!options.png.empty() && !is_interrupted) write_pngs(walks, options.png, progress);
    if (!options.movie.empty() && !is_interrupted) viz::write_movie(walks, options.movie, progress);
    progress.clear();
    if (is_interrupted) return;
    if (!has_output) fmt::print("{}\n", options.html);
    if (options.is_window) {
      const bool is_case = !options.one.text.empty();
      viz::show_window(is_case ? std::optional(walks.front().stage) : std::nullopt, options.topic);
    }
  });
  return is_interrupted ? 130 : status;
}
