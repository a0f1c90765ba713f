#include "command_line/command_line.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <utility>
#include <vector>

#include "case/reader/near_names.hpp"

namespace rayproof {
namespace {

/// Standard output holds back what it is given: only its last write finds out that the disk is full.
void finish_output() {
  errno = 0;
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
  const std::string why = errno == 0 ? "is the disk full?" : std::generic_category().message(errno);
  // A reader who has seen enough (`| head`) is no failure to speak of.
  if (errno != EPIPE) print_to_stderr("rayproof: the output cannot be written: {}\n", why);
  std::_Exit(2);
}

/// The first file that a program opens would take the number of a stream that was closed before it began, and
/// what is printed would go there. In its place stands what can't be read, or written; but complaints that
/// nobody reads are lost without a complaint.
void occupy_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0)
      (void)!::open("/dev/null", stream == STDOUT_FILENO ? O_RDONLY : O_WRONLY);
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/// What is wrong. An option that there is not comes first: it may be the misspelt one that is missing.
std::string sentence_of(const CLI::App& app, const CLI::ParseError& mistake) {
  for (const std::string& argument : app.remaining()) {
    if (!argument.starts_with("--") || argument.size() == 2) continue;
    const std::string given = argument.substr(0, argument.find('='));
    const auto meant = likely_name(given, option_names(app));
    return fmt::format("there is no option {}{}", given,
                       meant ? fmt::format("; did you mean {}?", *meant) : "");
  }
  return mistake.what();
}

/// What was given no value, as by `--json ""`: it would go for one that was not given. Where a value may be
/// left out, CLI11 makes it an empty one.
std::optional<std::string> name_of_empty(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options())
    if (option->get_expected_min() > 0 && std::ranges::count(option->results(), "") > 0)
      return option->get_name();
  return std::nullopt;
}

/// The option in whose list a name is empty, as by `--shape sphere,,plane`: CLI11 leaves that out.
std::optional<std::string> name_of_list_with_empty(const CLI::App& app, int argc, const char* const* argv) {
  const CLI::Option* asked = nullptr;
  for (int i = 1; i < argc; ++i) {
    std::string text = argv[i];
    if (text.starts_with("--")) {
      const std::size_t end = text.find('=');
      asked = app.get_option_no_throw(text.substr(0, end));
      if (end == std::string::npos) continue;
      text.erase(0, end + 1);
    }
    const char comma = asked == nullptr ? '\0' : asked->get_delimiter();
    if (comma != '\0' && (comma + text + comma).find({comma, comma}) != std::string::npos)
      return asked->get_name();
  }
  return std::nullopt;
}

}  // namespace

CommandLine::CommandLine(std::string description, std::string program)
    : CLI::App(std::move(description), std::move(program)) {}

CommandLine::~CommandLine() = default;

void print_trouble(const std::string& program, const std::exception& trouble) {
  if (std::ferror(stdout) == 0) print_to_stderr("{}: {}\n", program, trouble.what());
}

std::optional<int> parse_command_line(CommandLine& app, int argc, const char* const* argv) {
  occupy_closed_streams();
  std::atexit(finish_output);
  try {
    app.parse(argc, argv);
    const auto empty = name_of_empty(app), list = name_of_list_with_empty(app, argc, argv);
    if (empty) print_to_stderr("{}: {} is empty (--help says more)\n", app.get_name(), *empty);
    if (list && !empty)
      print_to_stderr("{}: a name in {} is empty (--help says more)\n", app.get_name(), *list);
    return empty || list ? std::optional(2) : std::nullopt;
  } catch (const CLI::Success& request) {  // --help
    return app.exit(request);
  } catch (const CLI::ParseError& mistake) {
    print_to_stderr("{}: {} (--help says more)\n", app.get_name(), sentence_of(app, mistake));
    return 2;
  }
}

}  // namespace rayproof
