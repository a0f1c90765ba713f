/// \file
/// rayproof report: speed against error, of every method in every arrangement, with other people's libraries
/// and the floor beside them; and how times grow.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>

#include "bench/figures/json.hpp"
#include "bench/page/choice_table.hpp"
#include "bench/page/page.hpp"
#include "bench/page/plot.hpp"
#include "bench/page/scaling_svg.hpp"
#include "bench/page/text.hpp"
#include "bench/report/describe_options.hpp"
#include "bench/scaling/scaling.hpp"
#include "bench/vtk/plot_png.hpp"
#include "case/files.hpp"
#include "command_line/command_line.hpp"
#include "command_line/idle_options.hpp"
#include "command_line/interrupt.hpp"
#include "command_line/progress_line.hpp"
#ifdef RAYPROOF_LEAVING
#include "bench/leaving/leaving.hpp"
#endif

namespace {

using namespace rayproof;

report::Measurements read_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  const std::string text = whole_text(in, path);
  try {
    return report::from_json(text);
  } catch (const report::FiguresError& trouble) {
    throw report::FiguresError(path + ": " + trouble.what());
  }
}

/// Writes leaving.svg, of rays that leave surfaces by every strategy, where no filter asks for something
/// else; gives the line that says so.
std::string write_leaving([[maybe_unused]] const report::BenchOptions& options,
                          [[maybe_unused]] ProgressLine& progress) {
#ifdef RAYPROOF_LEAVING
  if (options.has_filter() || !options.scaling.empty() || !options.figures.empty()) return "";
  constexpr std::size_t hits = 16384;
  const leaving::SearchResult result = leaving::search(
      {.cases = std::min(options.rays, hits), .precisions = options.wanted_precisions()}, is_interrupted,
      [&](double done, const std::string& what) { progress.show(done, what); });
  progress.clear();
  if (is_interrupted) return "";
  const std::filesystem::path file = std::filesystem::path(options.out) / "leaving.svg";
  write_file(file, report::leaving_svg(result));
  return "leaving the surface, over the size of the scene: " + file.string() + "\n";
#else
  return "";
#endif
}

report::Measurements measured(const report::BenchOptions& options, ProgressLine& progress) {
  const auto listener = [&](double done, const std::string& what) { progress.show(done, what); };
  report::Measurements figures = report::measure(options, is_interrupted, listener);
  figures.scaling = report::measure_scaling(options, is_interrupted, listener);
  progress.clear();
  return figures;
}

int run(const report::BenchOptions& options) {
  const std::optional<report::Measurements> baseline =
      options.baseline.empty() ? std::nullopt : std::optional(read_file(options.baseline));
  report::Conclusions found;
  if (!options.figures.empty()) found.figures = read_file(options.figures);
  make_folder(options.out);
  expect_writable(options.json);
  keep_on_interrupt();
  ProgressLine progress;
  if (options.figures.empty()) found.figures = measured(options, progress);
  const report::Measurements& figures = found.figures;
  if (!is_interrupted && options.figures.empty() && figures.scaling.empty() &&
      std::ranges::none_of(figures.rows, &report::BenchRow::has_errors))
    throw std::runtime_error("nothing was measured: no method that is asked for answers these families");
  if (is_interrupted && figures.rows.empty() && figures.scaling.empty()) {
    fmt::print("interrupted before anything was measured: no page is written\n");
    return 130;
  }
  if (baseline) found.baseline = {report::compare(*baseline, figures), baseline->machine};
  found.summaries = report::summarise(figures.rows);
  found.choices = report::choose(figures.rows);
  found.plots = report::make_plots(found.summaries);

  const std::filesystem::path out = options.out;
  fmt::print("{}", report::to_text(found));
  if (!options.json.empty()) write_file(options.json, report::to_json(figures));
  write_file(out / "index.html", report::to_page(found));
  fmt::print("page: {}\n", (out / "index.html").string());
  if (const std::string price = report::choices_in_svg(found.choices); !price.empty()) {
    write_file(out / "price.svg", price);
    fmt::print("the price of an exact answer: {}\n", (out / "price.svg").string());
  }
  for (const char* const curve : report::scaling_names) {
    const std::string svg = report::scaling_in_svg(figures.scaling, curve);
    if (svg.empty()) continue;
    const std::filesystem::path file = out / fmt::format("scaling-{}.svg", curve);
    write_file(file, svg);
    fmt::print("how times grow: {}\n", file.string());
  }
  for (const std::string& line : report::write_pngs(found.plots, out)) fmt::print("{}\n", line);
  if (!is_interrupted) fmt::print("{}", write_leaving(options, progress));
  if (is_interrupted) fmt::print("interrupted: only what is shown was measured\n");
  return is_interrupted ? 130 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine app(
      "Measures speed against error: every method, one ray at a time and in batches, on every family.",
      "rayproof report");
  report::BenchOptions options;
  report::describe(app, options);
  if (const auto status = parse_command_line(app, argc, argv)) return *status;
  try {
    if (options.is_quick && app.count("--rays") == 0) options.rays = 4096;
    if (app.count("--rays") != 0) options.judged = options.rays;
    if (options.is_quick && app.count("--time") == 0) options.seconds = 0.02;
    if (!options.figures.empty())
      refuse_all_options_but(app, {"--figures", "--baseline", "--out", "--json"},
                             "--figures measures nothing");
    if (!options.scaling.empty())
      refuse_options(app, {"--shape", "--method", "--family", "--precision"},
                     "--scaling measures curves alone");
    report::validate(options);
    return run(options);
  } catch (const std::exception& trouble) {
    print_trouble("rayproof report", trouble);
    return 2;
  }
}
