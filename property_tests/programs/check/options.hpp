#pragma once
#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "properties/campaign/state.hpp"
#include "subjects/command.hpp"

namespace rayproof::check {

/// The command line of rayproof check.
struct Options {
  Settings settings{};
  std::optional<std::uint64_t> cases{};  ///< where left out, as many as suit who is on trial
  std::string command{};                 ///< --subject-command
  std::vector<std::string> subjects{};   ///< --subject: names of the registry of peers
  /// Whether others than our own methods are on trial.
  [[nodiscard]] bool has_guests() const { return !command.empty() || !subjects.empty(); }
  double case_seconds = static_cast<double>(usual_case_time.count()) / 1000;
  std::string json{};
  std::string junit{};
  std::string findings{};
  std::string replay{};
  std::string corpus{};
  std::string out = "out/check";
  bool labels = false;
  bool campaign = false;
  bool resume = false;  ///< go on with the campaign in the folder
  campaign::Shard shard{};
};

/// The default of --cases for our own methods, and for a command, which takes longer for each.
inline constexpr std::uint64_t usual_cases = 10'000, usual_cases_of_command = 2'000;

/// Describes the options to `app`, which fills `options`.
void describe(CLI::App& app, Options& options);

/// Throws std::runtime_error with one sentence where an option was given that would change nothing.
void refuse_idle_options(const CLI::App& app, const Options& options);

}  // namespace rayproof::check
