#include "programs/check/corpus.hpp"

#include <fmt/format.h>

#include <istream>
#include <sstream>

#include "case/reader.hpp"
#include "programs/check/corpus_files.hpp"

namespace rayproof::check {

std::vector<Case> read_corpus(std::istream& in, const std::string& name) {
  std::vector<Case> cases;
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    try {
      cases.push_back(read_case(line));
    } catch (const Refusal& refusal) {
      throw std::runtime_error(fmt::format("{}:{}: {}", name, number, refusal.what()));
    }
  }
  return cases;
}

std::vector<Case> built_in_corpus() {
  std::vector<Case> all;
  for (const CorpusFile& file : corpus_files()) {
    std::istringstream lines{std::string(file.text)};
    for (Case& one : read_corpus(lines, file.name)) all.push_back(std::move(one));
  }
  return all;
}

}  // namespace rayproof::check
