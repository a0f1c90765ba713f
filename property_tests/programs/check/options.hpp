#pragma once
#include <CLI/CLI.hpp>
#include <string>

#include "properties/plan.hpp"

namespace rayproof::check {

/// The command line of rayproof check.
struct Options {
  Settings settings{};
  std::string json{};
  std::string junit{};
  std::string findings{};
  std::string replay{};
  std::string corpus{};
  std::string out = "out/check";
  bool measure = false;
  bool labels = false;

  std::vector<std::string> precision_names{};  ///< as typed; see finish
  long long seconds = 0;
};

/// Describes the options to `app`, which fills `options`.
void describe(CLI::App& app, Options& options);

/// Puts what was typed into the settings; to be called once the command line is parsed.
void finish(Options& options);

}  // namespace rayproof::check
