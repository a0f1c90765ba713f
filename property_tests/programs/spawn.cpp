/// \file
/// rayproof spawn: leaves surfaces by every strategy, and judges the rays exactly.

#include <fstream>

#include "case/writer.hpp"
#include "command_line/command_line.hpp"
#include "command_line/interrupt.hpp"
#include "command_line/precision_option.hpp"
#include "command_line/progress_line.hpp"
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
  app.add_option("--seed", settings.seed, "Where the random hits begin")->capture_default_str();
  app.add_option("--cases", settings.cases, "Hits for each shape and precision")->capture_default_str();
  app.add_option("--jobs", settings.jobs, "Threads; as many as the machine has where left out");
  list("--shape", settings.shapes, "Only these shapes");
  list("--strategy", settings.strategies, "Only these strategies");
  add_precision_option(app, options.settings.precisions);
  app.add_option("--json", options.json, "Write all figures, by the size of the scene, as JSON")
      ->type_name("FILE");
  app.add_option("--findings", options.findings, "Write the failing rays as cases, one a line")
      ->type_name("FILE");
  app.footer("Exit status: 0 what is proven holds; 1 not so; 2 wrong command line; 130 interrupted.");
}

void open(std::ofstream& file, const std::string& name) {
  if (name.empty()) return;
  file.open(name);
  if (!file) throw std::runtime_error(name + " cannot be written");
}

int run(const SpawnOptions& options) {
  if (const std::string sentence = leaving::unknown_names(options.settings); !sentence.empty())
    throw std::runtime_error(sentence);
  std::ofstream json, findings;
  open(json, options.json);
  open(findings, options.findings);
  keep_on_interrupt();
  ProgressLine progress;
  const leaving::SearchResult result =
      leaving::search(options.settings, is_interrupted,
                      [&](double done, const std::string& what) { progress.show(done, what); });
  progress.clear();
  json << leaving::json_text(options.settings, result);
  for (const leaving::FalseHit& failure : result.failures) findings << write_case(failure.left) << '\n';
  const std::string tenfold = leaving::text_tenfold(result);
  fmt::print("seed {}, {} hits for each shape and precision\n\n{}\n{}\n{}{}{}", options.settings.seed,
             options.settings.cases, leaving::text_table(result), leaving::text_shapes(result), tenfold,
             tenfold.empty() ? "" : "\n", leaving::text_failures(result));
  const std::vector<std::string> broken = leaving::broken_promises(result);
  for (const std::string& sentence : broken) fmt::print("{}\n", sentence);
  if (result.was_interrupted) fmt::print("interrupted: only what is shown was judged\n");
  fmt::print("{}\n", broken.empty() ? "what is proven holds" : "NOT all that is proven holds");
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
  } catch (const std::runtime_error& trouble) {
    fmt::print(stderr, "rayproof spawn: {}\n", trouble.what());
  }
  return 2;
}
