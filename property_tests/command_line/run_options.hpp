#pragma once
/// \file
/// The options --seed, --jobs, --case-seconds and --subject-command as every program takes them.

#include <fmt/format.h>

#include <charconv>
#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "subjects/command.hpp"

namespace rayproof {

/// CLI11's own conversion takes -1 for 2^64 - 1, and whatever is larger than that for it, too.
inline void add_seed_option(CLI::App& app, std::uint64_t& into, const std::string& text) {
  const auto read = [](std::string& given) -> std::string {
    std::uint64_t seed = 0;
    const char* const end = given.data() + given.size();
    const auto [stop, error] = std::from_chars(given.data(), end, seed);
    const bool is_seed = error == std::errc{} && stop == end;
    return is_seed ? "" : fmt::format("{} is not a whole number from 0 to {}", given, UINT64_MAX);
  };
  app.add_option("--seed", into, text)->capture_default_str()->check(CLI::Validator(read, ""));
}

inline void add_jobs_option(CLI::App& app, int& into) {
  app.add_option("--jobs", into, "Threads; as many as the machine has where left out")
      ->check(CLI::Range(1, 1024));
}

/// CLI11's own Range takes nan for a number in every range.
[[nodiscard]] inline CLI::Validator seconds_between(double least, double most) {
  const auto read = [least, most](std::string& given) -> std::string {
    char* end = nullptr;
    const double seconds = std::strtod(given.c_str(), &end);
    const bool is_time = end != given.c_str() && *end == 0 && seconds >= least && seconds <= most;
    return is_time ? "" : fmt::format("{} is not a number of seconds from {} to {}", given, least, most);
  };
  return CLI::Validator(read, "");
}

inline void add_case_seconds_option(CLI::App& app, double& into) {
  app.add_option("--case-seconds", into, "How long a program may be silent while a case waits for its answer")
      ->capture_default_str()
      ->check(seconds_between(least_case_seconds, most_case_seconds));
}

/// Of --subject-command: without one, other subjects would be put on trial in its place.
[[nodiscard]] inline CLI::Validator no_blank_command() {
  const auto read = [](std::string& given) -> std::string {
    return given.find_first_not_of(" \t\n") == std::string::npos ? "the command is blank" : "";
  };
  return CLI::Validator(read, "");
}

}  // namespace rayproof
