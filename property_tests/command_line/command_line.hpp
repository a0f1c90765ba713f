#pragma once
/// \file
/// Command lines as every program takes them: --help ends with 0, a mistake with 2 and one sentence.

// For the programs, which all speak by fmt.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <optional>
#include <string>

#include "case/print_to_stderr.hpp"

namespace rayproof {

/// A command line to describe options to. All that CLI11 parses, writes help and reads configurations with
/// hangs on its constructor and destructor, and is compiled with them, once for all programs.
class CommandLine : public CLI::App {
 public:
  CommandLine(std::string description, std::string program);
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;
  ~CommandLine() override;
};

/// Parses the command line, and sees to it that a program whose output was lost ends with 2. Gives the exit
/// status where the program is to end here.
[[nodiscard]] std::optional<int> parse_command_line(CommandLine& app, int argc, const char* const* argv);

/// One sentence on standard error about what ended the program. What its end will say of an output that was
/// lost is not said twice.
void print_trouble(const std::string& program, const std::exception& trouble);

}  // namespace rayproof
