#pragma once
#include <string_view>
#include <vector>

namespace rayproof::check {

/// A file of the corpus folder.
struct CorpusFile {
  const char* name;
  std::string_view text;
};

/// The files the program was built with; made by cmake/corpus.cmake.
[[nodiscard]] std::vector<CorpusFile> corpus_files();

}  // namespace rayproof::check
