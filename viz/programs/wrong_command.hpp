#pragma once
/// \file
/// What ends a program: a mistake in the command line that CLI11 can't see, with status 2, or a Refusal.

#include <stdexcept>

#include "case/shape_format.hpp"
#include "command_line/command_line.hpp"

namespace rayproof::viz {

class WrongCommand : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Runs `body` and turns what it throws into one sentence on standard error and the exit status.
template <class Body>
[[nodiscard]] int run_and_report(const char* program, Body&& body) {
  const auto report = [program](const std::exception& why, int status) {
    print_trouble(program, why);
    return status;
  };
  try {
    body();
    return 0;
  } catch (const Refusal& refused) {
    return report(refused, 1);
  } catch (const std::runtime_error& mistake) {
    return report(mistake, 2);
  }
}

}  // namespace rayproof::viz
