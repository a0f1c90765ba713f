#include "programs/stream/answer_stream.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "case/print_to_stderr.hpp"

namespace rayproof {

const char* const stream_help =
    R"(Input: one case a line (docs/case-format.md). Output: one line for each, in order, in the same format for
every program that answers cases. A refused line gets {"id": ..., "line": N, "error": "..."} and the rest goes
on. Each line is answered as soon as it arrives, so that another program can ask through a pipe.

Exit status: 0 where every line was answered, 1 where a line was refused, 2 for a wrong command line or a file
that cannot be read.)";

int run_stream_program(const std::string& file, const AnswerFunction& answer) {
  try {
    const int input = file == "-" ? STDIN_FILENO : ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (input < 0) throw std::system_error(errno, std::generic_category(), file + " cannot be opened");
    if (std::error_code error; std::filesystem::is_directory(file, error))
      throw std::system_error(EISDIR, std::generic_category(), file + " cannot be read");
    return answer_stream(input, STDOUT_FILENO, answer) > 0 ? 1 : 0;
  } catch (const std::system_error& error) {
    // A reader who has seen enough (`| head`) is no failure to speak of.
    if (error.code() != std::errc::broken_pipe) print_to_stderr("rayproof: {}\n", error.what());
    return 2;
  }
}

}  // namespace rayproof
