#pragma once
/// \file
/// Options that would change nothing beside others are refused: whoever gives one expects something of it.

#include <fmt/format.h>

#include <algorithm>
#include <CLI/CLI.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace rayproof {

/// Throws std::runtime_error, "WHY: leave --OPTION out", where one of these was given.
inline void refuse_options(const CLI::App& app, const std::vector<std::string>& idle,
                           const std::string& why) {
  for (const std::string& name : idle)
    if (app.count(name) > 0) throw std::runtime_error(fmt::format("{}: leave {} out", why, name));
}

/// The same where any was given but these.
inline void refuse_all_options_but(const CLI::App& app, const std::vector<std::string>& kept,
                                   const std::string& why) {
  for (const CLI::Option* option : app.get_options()) {
    const auto is_called = [option](const std::string& name) { return option->check_name(name); };
    if (option->count() > 0 && std::ranges::none_of(kept, is_called))
      throw std::runtime_error(fmt::format("{}: leave {} out", why, option->get_name()));
  }
}

}  // namespace rayproof
