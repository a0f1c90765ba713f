#include "programs/check/corpus.hpp"

#include <fmt/format.h>

#include <sstream>

#include "case/files.hpp"
#include "case/reader.hpp"

namespace rayproof::check {

namespace {

void append_cases(std::vector<Case>& cases, std::istream& in, const std::string& name) {
  std::string line;
  for (std::size_t number = 1; read_line(in, line, name); ++number) {
    try {
      cases.push_back(read_case(line));
    } catch (const Refusal& refusal) {
      throw std::runtime_error(fmt::format("{}:{}: {}", name, number, refusal.what()));
    }
  }
}

}  // namespace

std::vector<Case> read_corpus(const std::string& file) {
  std::vector<Case> cases;
  if (!file.empty()) {
    std::ifstream in = opened_to_read(file);
    append_cases(cases, in, file);
    return cases;
  }
  for (const CorpusFile& built_in : corpus_files()) {
    std::istringstream in{std::string(built_in.text)};
    append_cases(cases, in, built_in.name);
  }
  return cases;
}

}  // namespace rayproof::check
