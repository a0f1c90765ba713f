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
  bool labels = false;
};

/// Describes the options to `app`, which fills `options`.
void describe(CLI::App& app, Options& options);

}  // namespace rayproof::check
