#pragma once
/// \file
/// The option --precision as every program takes it.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace rayproof {

/// Puts the precisions that --precision names in place of those in `into`.
inline void add_precision_option(CLI::App& app, std::vector<Precision>& into) {
  const auto set = [&into](const std::vector<std::string>& names) {
    into.clear();
    for (const std::string& name : names) into.push_back(precision_named(name));
  };
  app.add_option_function<std::vector<std::string>>("--precision", set, "Only float32 or float64")
      ->delimiter(',')
      ->check(CLI::IsMember({"float32", "float64"}));
}

}  // namespace rayproof
