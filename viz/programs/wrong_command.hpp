#pragma once
/// \file
/// A mistake in the command line that CLI11 can't see; the program ends with status 2.

#include <stdexcept>

namespace rayproof::viz {

class WrongCommand : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace rayproof::viz
