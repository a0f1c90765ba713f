#include "command_line/command_line.hpp"

#include <utility>

namespace rayproof {

CommandLine::CommandLine(std::string description, std::string program)
    : CLI::App(std::move(description), std::move(program)) {}

CommandLine::~CommandLine() = default;

std::optional<int> parse_command_line(CommandLine& app, int argc, const char* const* argv) {
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
