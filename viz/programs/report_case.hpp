#pragma once
/// \file
/// What `explain` and `draw` have in common: CASE and --method on the command line, answered; and what ends a
/// program: a mistake in the command line that CLI11 can't see, with status 2, or a Refusal.

#include <fmt/format.h>

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "case/reader/near_names.hpp"
#include "case/shape_format.hpp"
#include "command_line/command_line.hpp"
#include "command_line/count_option.hpp"
#include "command_line/idle_options.hpp"
#include "subjects/command.hpp"
#include "viz/explain/case_argument.hpp"
#include "viz/programs/report_of.hpp"

namespace rayproof::viz {

class WrongCommand : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Runs `body` and turns what it throws into one sentence on standard error and the exit status.
template <class Body>
[[nodiscard]] int run_and_report(const char* program, Body&& body) {
  const auto report = [program](const std::exception& why, int status) {
    print_trouble(program, why);
    return status;
  };
  try {
    body();
    return 0;
  } catch (const Refusal& refused) {
    return report(refused, 1);
  } catch (const std::runtime_error& mistake) {
    return report(mistake, 2);
  }
}

struct CaseOptions {
  std::string text{};                    ///< CASE
  std::string findings = last_findings;  ///< the file of the run whose finding a number names
  std::optional<std::size_t> line{};
  std::string method{};
  std::string precision{};

  /// --from, and the options that are given back, for a case alone.
  std::array<CLI::Option*, 3> add_choices_to(CLI::App& app, const std::string& which_method) {
    app_ = &app;
    app.add_option("--from", findings, "The findings of the run whose number is given, or its folder")
        ->capture_default_str()
        ->type_name("FILE");
    return {
        app.add_option("--line", line,
                       "Which line of the file, from 1, blank ones counted; the first case where left out")
            ->transform(whole_count()),
        app.add_option("--method", method, which_method)->type_name("SHAPE/METHOD"),
        app.add_option("--precision", precision, "Round the case to this in place of its own precision")
            ->check(CLI::IsMember({"float32", "float64"}))};
  }

  void add_to(CLI::App& app) {
    app.add_option("CASE", text,
                   "The number of a finding of rayproof check, a file, - for standard input, or one case or "
                   "finding as JSON")
        ->required();
    add_choices_to(app, "The method, as in sphere/textbook; a finding brings its own");
    app.footer("Exit status: 0 done, 1 the case is refused, 2 wrong command line.");
  }

  /// Throws std::runtime_error where an option was given that changes nothing for this CASE.
  void refuse_idle() const {
    const bool is_number = finding_number(text).has_value();
    if (!is_number) refuse_options(*app_, {"--from"}, "no number of a finding is given");
    if (is_number || text.starts_with('{')) refuse_options(*app_, {"--line"}, "no file of cases is given");
  }

 private:
  const CLI::App* app_ = nullptr;
};

/// The subject to ask, or a WrongCommand that names likely ones: where the topic has any, only such as have
/// steps to show.
inline const Subject& subject_for(const Case& one, const std::string& method) {
  const Subject* const subject = find_subject(method);
  if (subject != nullptr && subject->topic == topic_of(one)) return *subject;
  std::vector<std::string> names = recordable_methods(one, method);
  if (names.empty()) {
    for (const Subject& other : subjects()) {
      if (other.topic == topic_of(one)) names.push_back(other.full_name());
    }
    names = near_names(method, std::move(names), 3);
  }
  const std::string likely = fmt::format("{}", fmt::join(names, " or "));
  if (subject != nullptr) {
    throw WrongCommand(
        fmt::format("{} does not answer a case about a {}; try {}", method, topic_of(one), likely));
  }
  throw WrongCommand(fmt::format("there is no method {}; did you mean {}?", method, likely));
}

/// The same of a finding whose subject is a program, which is started and asked. Where it gives no answer and
/// that is the finding, the exact answer alone, and why; else throws std::runtime_error.
[[nodiscard]] inline CaseReport report_on_program(const CaseArgument& argument) {
  for (const Subject& one : subjects_of_command(command_name, argument.command, argument.case_time)) {
    if (one.full_name() != argument.method) continue;
    try {
      return report_of(argument.one, &one);
    } catch (const std::runtime_error& silence) {
      if (argument.is_answered) throw;
      print_to_stderr("{}: the exact answer alone\n", silence.what());
      CaseReport report = report_of(argument.one, nullptr);
      report.method = argument.method;
      return report;
    }
  }
  throw WrongCommand("there is no method " + argument.method);
}

/// Reads the case, asks the oracle and the method. Throws WrongCommand, UnreadableCase or a Refusal.
[[nodiscard]] inline CaseReport report_case(const CaseOptions& options) {
  options.refuse_idle();
  std::optional<Precision> precision;
  if (!options.precision.empty()) precision = precision_named(options.precision);
  const auto argument =
      read_case_argument(text_of_case(options.text, options.line, options.findings), precision);
  if (options.method.empty() && !argument.command.empty()) return report_on_program(argument);
  const std::string method = options.method.empty() ? argument.method : options.method;
  return report_of(argument.one, method.empty() ? nullptr : &subject_for(argument.one, method));
}

}  // namespace rayproof::viz
