#pragma once
#include <iosfwd>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace rayproof::check {

/// The cases of the corpus folder, as they were when the program was built.
[[nodiscard]] std::vector<Case> built_in_corpus();

/// The cases of a file, one a line; `name` stands in messages. Throws std::runtime_error with one sentence
/// that names the line.
[[nodiscard]] std::vector<Case> read_corpus(std::istream& in, const std::string& name);

}  // namespace rayproof::check
