/// \file
/// rayproof spawn: leaves surfaces by every strategy, and judges the rays exactly.

#include "case/files.hpp"
#include "case/one_file.hpp"
#include "command_line/command_line.hpp"
#include "command_line/count_option.hpp"
#include "command_line/interrupt.hpp"
#include "command_line/precision_option.hpp"
#include "command_line/progress_line.hpp"
#include "command_line/run_options.hpp"
#include "properties/leaving/text.hpp"

namespace {

using namespace rayproof;

struct SpawnOptions {
  leaving::SearchSettings settings{};
  std::string json{};
  std::string findings{};
};

void describe(CLI::App& app, SpawnOptions& options) {
  const auto list = [&](const char* name, std::vector<std::string>& into, const char* text) {
    app.add_option(name, into, text)->delimiter(',');
  };
  leaving::SearchSettings& settings = options.settings;
  settings.cases = 65536;
  add_seed_option(app, settings.seed, "Where the random hits begin");
  app.add_option("--cases", settings.cases, "Hits for each shape and precision")
      ->capture_default_str()
      ->transform(whole_count());
  add_jobs_option(app, settings.jobs);
  list("--shape", settings.shapes, "Only these shapes");
  list("--strategy", settings.strategies, "Only these strategies");
  add_precision_option(app, options.settings.precisions);
  app.add_option("--json", options.json, "Write all figures, by the size of the scene, as JSON")
      ->type_name("FILE");
  app.add_option("--findings", options.findings, "Write the failing rays as cases, one a line")
      ->type_name("FILE");
  app.footer("Exit status: 0 what is proven holds; 1 not so; 2 wrong command line; 130 interrupted.");
}

int run(const SpawnOptions& options) {
  if (const std::string sentence = leaving::unknown_names(options.settings); !sentence.empty())
    throw std::runtime_error(sentence);
  refuse_one_file("--json", options.json, "--findings", options.findings);
  for (const std::string& file : {options.json, options.findings}) expect_writable(file);
  keep_on_interrupt();
  ProgressLine progress;
  const leaving::SearchResult result =
      leaving::search(options.settings, is_interrupted,
                      [&](double done, const std::string& what) { progress.show(done, what); });
  progress.clear();
  if (!options.findings.empty()) write_file(options.findings, leaving::case_lines(result));
  if (!options.json.empty()) write_file(options.json, leaving::json_text(options.settings, result));
  const std::string tenfold = leaving::text_tenfold(result);
  fmt::print("seed {}, {} hits for each shape and precision\n\n{}\n{}\n{}{}{}", options.settings.seed,
             options.settings.cases, leaving::text_table(result), leaving::text_shapes(result), tenfold,
             tenfold.empty() ? "" : "\n", leaving::text_failures(result));
  const std::vector<std::string> broken = leaving::broken_promises(result);
  for (const std::string& sentence : broken) fmt::print("{}\n", sentence);
  if (result.was_interrupted) fmt::print("interrupted: only what is shown was judged\n");
  fmt::print("{}\n", !broken.empty()          ? "NOT all that is proven holds"
                     : result.was_interrupted ? "nothing that is proven is broken by what was judged"
                                              : "what is proven holds");
  return result.was_interrupted ? 130 : broken.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine app("Leaves surfaces by every strategy, and judges the rays exactly.", "rayproof spawn");
  SpawnOptions options;
  describe(app, options);
  if (const auto status = parse_command_line(app, argc, argv)) return *status;
  try {
    return run(options);
  } catch (const std::exception& trouble) {
    print_trouble("rayproof spawn", trouble);
  }
  return 2;
}
