#pragma once
/// \file
/// The option --time as every program takes it.

#include <fmt/format.h>

#include <chrono>
#include <CLI/CLI.hpp>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>

namespace rayproof {

/// Takes 90, 90s, 10m, 1.5h for a time of more than nothing and at most a year, and puts it into `into`.
inline void add_time_option(CLI::App& app, std::optional<std::chrono::duration<double>>& into,
                            const std::string& text) {
  const auto read = [](std::string& given) -> std::string {
    static const std::map<std::string, double> units{{"", 1}, {"s", 1}, {"m", 60}, {"h", 3600}};
    char* end = nullptr;
    const double count = std::strtod(given.c_str(), &end);
    const auto unit = units.find(end);
    const double seconds = unit == units.end() || end == given.c_str() ? 0 : count * unit->second;
    if (!(seconds > 0 && seconds <= 366 * 86400.0))
      return fmt::format("{} is no time like 90s, 10m or 2h, of a year at most", given);
    given = fmt::format("{}", seconds);
    return "";
  };
  app.add_option_function<double>(
         "--time", [&into](double seconds) { into = std::chrono::duration<double>(seconds); },
         text + ": seconds, or as 10m or 2h")
      ->transform(CLI::Validator(read, "TIME"));
}

}  // namespace rayproof
