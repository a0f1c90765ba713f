#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "case/case.hpp"

namespace rayproof::check {

/// The cases of a file, one a line; with no name, those of the corpus folder as it was when the program was
/// built. Throws std::runtime_error with one sentence that names the line.
[[nodiscard]] std::vector<Case> read_corpus(const std::string& file);

/// A file of the corpus folder.
struct CorpusFile {
  const char* name;
  std::string_view text;
};

/// The files the program was built with; made by cmake/corpus.cmake.
[[nodiscard]] std::vector<CorpusFile> corpus_files();

}  // namespace rayproof::check
