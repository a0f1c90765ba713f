#pragma once
/// \file
/// The command line of rayproof leak.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "leaks/search.hpp"
#include "subjects/command.hpp"

namespace rayproof::leaks {

struct LeakOptions {
  LeakSettings settings{};
  std::string mesh = "knot";
  std::vector<std::string> methods{};
  std::string command{};                ///< --subject-command
  std::vector<std::string> subjects{};  ///< --subject: names of the registry of peers
  double case_seconds = static_cast<double>(usual_case_time.count()) / 1000;
  std::string out = "out/leak";
  std::string json{};

  [[nodiscard]] bool has_guests() const { return !command.empty() || !subjects.empty(); }
};

/// Describes the options to `app`, which fills `options`.
void describe(CLI::App& app, LeakOptions& options);

}  // namespace rayproof::leaks
