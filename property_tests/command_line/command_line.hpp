#pragma once
/// \file
/// Command lines as every program takes them: --help ends with 0, a mistake with 2 and one sentence.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <optional>

namespace rayproof {

/// Parses the command line; gives the exit status where the program is to end here.
[[nodiscard]] inline std::optional<int> parse_command_line(CLI::App& app, int argc, const char* const* argv) {
  try {
    app.parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::Success& request) {  // --help
    return app.exit(request);
  } catch (const CLI::ParseError& mistake) {
    fmt::print(stderr, "{}: {} (--help says more)\n", app.get_name(), mistake.what());
    return 2;
  }
}

}  // namespace rayproof
