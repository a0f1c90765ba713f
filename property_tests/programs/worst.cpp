/// \file
/// rayproof worst: looks for each method's worst cases by varying the worst that it knows.

#include "case/files.hpp"
#include "case/one_file.hpp"
#include "command_line/command_line.hpp"
#include "command_line/count_option.hpp"
#include "command_line/idle_options.hpp"
#include "command_line/interrupt.hpp"
#include "command_line/precision_option.hpp"
#include "command_line/progress_line.hpp"
#include "command_line/run_options.hpp"
#include "command_line/time_option.hpp"
#include "properties/worst/search.hpp"

namespace {

using namespace rayproof;

struct WorstOptions {
  worst::WorstSearch what{};
  std::string out = "out/worst";
  std::string json{};
};

void describe_filters(CLI::App& app, WorstOptions& options) {
  const auto list = [&](const char* name, std::vector<std::string>& into, const char* text) {
    app.add_option(name, into, text)->delimiter(',');
  };
  Settings& plan = options.what.plan;
  list("--shape,--topic", plan.shapes, "Only methods of these shapes");
  list("--method", plan.methods,
       "Only these methods: centred, or sphere/centred; the misprinted ones only so");
  list("--family", plan.families, "Begin with cases of these families");
  add_precision_option(app, plan.precisions);
}

void describe(CLI::App& app, WorstOptions& options) {
  Settings& plan = options.what.plan;
  plan.cases = 100'000;
  add_seed_option(app, plan.seed, "Where the search begins");
  app.add_option("--cases", plan.cases, "Cases for each method and precision")
      ->capture_default_str()
      ->transform(whole_count());
  add_time_option(app, options.what.time, "In place of --cases: time for each method and precision");
  app.add_flag("--compare", options.what.compare, "Draw cases at random as long, too, and show both");
  add_jobs_option(app, plan.jobs);
  describe_filters(app, options);
  app.add_option("--out", options.out, "Folder for findings.jsonl, the worst cases")
      ->capture_default_str()
      ->type_name("DIR");
  app.add_option("--json", options.json, "Write all figures and cases as one JSON object")->type_name("FILE");
  app.footer(
      "Each worst found is a lower bound of the worst there is; a promise with a star is proven.\n"
      "The same seed and number of cases give the same output, whatever the number of jobs.\n"
      "Exit status: 0 no promise is exceeded; 1 one is; 2 wrong command line; 130 interrupted.");
}

/// Writes the worst cases, a line each; gives how many there are.
std::size_t write_findings(const worst::WorstResult& result, const std::filesystem::path& file) {
  std::size_t number = 0;
  std::string lines;
  for (const worst::WorstRow& row : result.rows)
    if (row.found) lines += write_finding(worst::finding_of(row, ++number)) + '\n';
  write_file(file, lines);
  return number;
}

int run(const WorstOptions& options) {
  (void)make_plan(options.what.plan);  // refuses unknown names before anything is written
  const std::filesystem::path name = std::filesystem::path(options.out) / "findings.jsonl";
  refuse_one_file("--json", options.json, "--out", name);
  make_folder(options.out);
  for (const std::filesystem::path& file : {name, std::filesystem::path(options.json)}) expect_writable(file);
  keep_on_interrupt();
  ProgressLine progress;
  const worst::WorstResult result = worst::search(
      options.what, is_interrupted, [&](double done, const std::string& what) { progress.show(done, what); });
  progress.clear();
  const std::size_t count = write_findings(result, name);
  if (!options.json.empty()) write_file(options.json, worst::json_text(options.what, result));
  fmt::print("seed {}, {} cases by guided search, {} by draws alone\n\n{}\n{}", options.what.plan.seed,
             result.climbed, result.drawn, worst::text_table(result), worst::text_exceeded(result));
  fmt::print("{} worst cases: {}; rayproof explain N --from {} looks into one\n", count, name.string(),
             name.string());
  if (result.was_interrupted) fmt::print("interrupted: only what is shown was searched\n");
  return result.was_interrupted ? 130 : result.keeps_promises() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine app("Looks for each method's worst cases by varying the worst that it knows.",
                  "rayproof worst");
  WorstOptions options;
  describe(app, options);
  if (const auto status = parse_command_line(app, argc, argv)) return *status;
  try {
    if (options.what.time) refuse_options(app, {"--cases"}, "--time stands in place of --cases");
    return run(options);
  } catch (const std::exception& trouble) {
    print_trouble("rayproof worst", trouble);
  }
  return 2;
}
