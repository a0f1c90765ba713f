#include "programs/check/options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>

#include "command_line/count_option.hpp"
#include "command_line/idle_options.hpp"
#include "command_line/precision_option.hpp"
#include "command_line/run_options.hpp"
#include "command_line/time_option.hpp"
#include "subjects/subject.hpp"

namespace rayproof::check {

namespace {

constexpr const char* footer =
    "Filters may be given several times, or as lists with commas. The corpus of past failures runs first, "
    "every time.\n"
    "Findings are numbered: rayproof explain N, walk N, draw N and replay N look into finding N of the last "
    "run.\n"
    "The same seed gives the same cases whatever the number of jobs.\n"
    "Exit status: 0 every declared contract holds and every method declared wrong was refuted; 1 not so; 2 "
    "wrong command\n"
    "line; 130 interrupted.";

void describe_filters(CLI::App& app, Options& options) {
  const auto list = [&](const char* name, std::vector<std::string>& into, const std::string& text) {
    return app.add_option(name, into, text)->delimiter(',');
  };
  Settings& settings = options.settings;
  list("--shape,--topic", settings.shapes, fmt::format("Only methods of {}", fmt::join(topics(), ", ")));
  list("--method", settings.methods, "Only this method: centred, or sphere/centred");
  list("--property", settings.properties, "Only this property");
  list("--family", settings.families, "Only this family of cases");
  add_precision_option(app, settings.precisions);
}

void describe_guests(CLI::App& app, Options& options) {
  app.add_option(
         "--subject-command", options.command,
         "Put this program on trial in place of our methods: a shell line that reads cases, one a line, "
         "on standard input and writes an answer to each, in any order, each flushed "
         "(docs/case-format.md)")
      ->type_name("COMMAND")
      ->check(no_blank_command());
  app.add_option(
         "--subject", options.subjects,
         "Put these libraries on trial in place of our methods: names, or `peers` for all that are built "
         "(docs/peers.md)")
      ->delimiter(',')
      ->type_name("NAME");
  add_case_seconds_option(app, options.case_seconds);
}

/// "3/8" as a shard.
std::string read_shard(const std::string& text, campaign::Shard& shard) {
  std::istringstream stream(text);
  char slash = 0;
  if (!(stream >> shard.number >> slash >> shard.count) || slash != '/' || !stream.eof() ||
      shard.number < 1 || shard.number > shard.count || shard.count > campaign::most_shards)
    return fmt::format("{} is not I/N with I from 1 to N", text);
  return "";
}

void describe_campaign(CLI::App& app, Options& options) {
  auto* const campaign =
      app.add_flag("--campaign", options.campaign,
                   "A long run in rounds: --cases of each method, shared by its families and "
                   "precisions; its state is DIR/campaign.json");
  app.add_option("--shard", "Only the I-th of N parts; rayproof merge puts them together")
      ->type_name("I/N")
      ->needs(campaign)
      ->each([&options](const std::string& text) {
        if (const std::string trouble = read_shard(text, options.shard); !trouble.empty())
          throw CLI::ValidationError(trouble);
      });
  app.add_flag("--resume", options.resume, "Go on with the campaign in DIR")->needs(campaign);
}

void describe_outputs(CLI::App& app, Options& options) {
  const auto file = [&](const char* name, std::string& into, const char* text) {
    app.add_option(name, into, text)->type_name("FILE");
  };
  app.add_option("--out", options.out, "Folder for the page index.html and for findings.jsonl")
      ->capture_default_str()
      ->type_name("DIR");
  file("--findings", options.findings, "Write each finding as a line of JSON here, too, at once");
  file("--json", options.json, "Write all figures as one JSON object");
  file("--junit", options.junit, "Write the outcome as JUnit XML");
  file("--replay", options.replay, "Judge just the findings or cases of this file again");
  file("--corpus", options.corpus, "Cases to run first, in place of the built-in corpus");
  app.add_flag(
      "--measure", options.settings.measure_all,
      "Also print the worst errors of each family, and the worst figures as the contracts write them");
  app.add_flag("--labels", options.labels, "Also print what the families produced");
}

}  // namespace

void describe(CLI::App& app, Options& options) {
  Settings& settings = options.settings;
  add_seed_option(app, settings.seed, "Where the random cases begin");
  app.add_option("--cases", options.cases,
                 fmt::format("Cases for each method, family and precision; {} of a --subject-command",
                             usual_cases_of_command))
      ->default_str(std::to_string(usual_cases))
      ->transform(whole_count());
  add_time_option(app, settings.time, "Stop after this time; every family has its share of it");
  add_jobs_option(app, settings.jobs);
  describe_guests(app, options);
  describe_campaign(app, options);
  describe_filters(app, options);
  describe_outputs(app, options);
  app.footer(footer);
}

void refuse_idle_options(const CLI::App& app, const Options& options) {
  if (options.campaign) {
    if (options.has_guests() || !options.replay.empty())
      throw std::runtime_error(
          "--campaign is about the library's own methods: leave --subject, --subject-command and --replay "
          "out");
    refuse_options(app, {"--corpus", "--labels"}, "--campaign draws new cases alone");
  }
  if (!options.replay.empty()) {
    if (options.has_guests())
      throw std::runtime_error(
          "--replay asks whoever a finding names, and of a bare case the library's own methods: leave "
          "--subject and "
          "--subject-command out, or give the cases as --corpus FILE");
    if (!options.json.empty() || !options.junit.empty() || !options.findings.empty())
      throw std::runtime_error("--replay prints what comes of it: leave --json, --junit and --findings out");
    refuse_all_options_but(app, {"--replay"}, "--replay judges every line of its file");
  }
  if (options.has_guests())
    refuse_options(app, {"--labels", "--measure"}, "a program's answers are judged without a contract");
  else
    refuse_options(app, {"--case-seconds"}, "no --subject-command and no --subject is to be waited for");
}

}  // namespace rayproof::check
