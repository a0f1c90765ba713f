#pragma once
/// \file
/// One mutant on the cases, in a process of its own: it may crash, or never end.

#include <string>

#include "mutation/program/notes.hpp"

namespace rayproof::mutation {

/// What became of a mutant: the property it broke and in which case, or how its process ended.
struct MutantResult {
  std::string ended{};  ///< "", the name of a property, "crash" or "hang"
  std::size_t input = 0;
};

/// Runs the mutant on the cases in which it makes a difference, until it breaks a property.
[[nodiscard]] MutantResult try_mutant(const Target& target, const std::vector<Input>& inputs,
                                      const Notes& notes, int number);

/// A line of the results.
[[nodiscard]] std::string as_json(int number, const Notes& notes, const MutantResult& result,
                                  const std::vector<Input>& inputs);

}  // namespace rayproof::mutation
