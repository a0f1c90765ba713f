#include "dossier/collection.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>

#include "case/files.hpp"
#include "case/findings_file.hpp"
#include "case/json/ordered.hpp"

namespace rayproof::dossier {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> lines_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!is_readable(in, file))
    throw std::runtime_error(file.string() + " can't be read: it is written by rayproof check --subject");
  std::vector<std::string> lines = lines_in(whole_text(in, file.string()));
  std::erase_if(lines, is_blank);
  return lines;
}

JudgedShape judged_in(const std::string& line) {
  const Json json = read_json(line);
  JudgedShape judged;
  judged.shape = json.at("shape");
  judged.name = json.at("method");
  for (const auto& [name, into] :
       {std::pair("seed", &judged.seed), std::pair("cases_each", &judged.cases_each),
        std::pair("cases", &judged.cases), std::pair("unsupported", &judged.unsupported),
        std::pair("failures", &judged.failures)})
    *into = json.at(name).get<std::uint64_t>();
  for (const auto& [claim, count] : json.at("judged").items()) judged.claims.emplace_back(claim, count);
  judged.not_judged = json.at("not_judged");
  return judged;
}

/// The worst kind first; of one kind what broke on most cases.
bool is_worse(const FiledFinding& a, const FiledFinding& b) {
  const auto rank = [](const FiledFinding& one) {
    return std::pair(std::ranges::find(kind_names, one.recorded().kind) - kind_names.begin(),
                     -static_cast<double>(one.recorded().finding.cases));
  };
  return rank(a) < rank(b);
}

/// Of one subject or function, with one diagnosis; what nothing cures may be anything.
bool is_same_fault(const FiledFinding& a, const FiledFinding& b) {
  const RecordedFinding &one = a.recorded(), &other = b.recorded();
  const std::string &cure = one.finding.diagnosis, &function = a.dossier.reproduction.function;
  const bool is_one_function = !function.empty() && function == b.dossier.reproduction.function;
  return (one.name == other.name || is_one_function) && !cure.empty() && !cure.starts_with("nothing") &&
         cure == other.finding.diagnosis;
}

FiledFinding filed(const std::string& line, const std::string& command) {
  FiledFinding made;
  Json bare = read_json(line);
  bare.erase("command");  // a path of this machine
  made.line = write_json(bare);
  RecordedFinding recorded = read_recorded(line, 0);
  try {
    made.dossier = open_dossier(recorded, command);
  } catch (const std::runtime_error& problem) {
    made.trouble = problem.what();
    made.dossier.recorded = std::move(recorded);
  }
  return made;
}

/// The library of a name, made where there is none.
LibraryDossier& library_called(std::vector<LibraryDossier>& all, const LibraryFacts& facts) {
  const auto found =
      std::ranges::find_if(all, [&](const LibraryDossier& one) { return one.facts.name == facts.name; });
  if (found != all.end()) return *found;
  all.push_back({facts});
  return all.back();
}

}  // namespace

std::vector<FiledFinding> joined(std::vector<FiledFinding> findings) {
  std::vector<FiledFinding> kept;
  for (FiledFinding& next : findings) {
    const auto same =
        std::ranges::find_if(kept, [&](const FiledFinding& one) { return is_same_fault(one, next); });
    if (same == kept.end()) {
      kept.push_back(std::move(next));
      continue;
    }
    same->dossier.recorded.finding.cases += next.recorded().finding.cases;
    const auto place = next.place();
    const bool is_named =
        place == same->place() || std::ranges::find(same->also_in, place) != same->also_in.end();
    if (!is_named) same->also_in.push_back(place);
  }
  return kept;
}

std::vector<LibraryDossier> collect(const std::vector<std::filesystem::path>& folders,
                                    const std::vector<std::pair<std::string, std::string>>& commands,
                                    const std::function<void(double)>& progress) {
  std::vector<std::string> findings, judged;
  for (const std::filesystem::path& folder : folders) {
    std::ranges::move(lines_of(folder / "findings.jsonl"), std::back_inserter(findings));
    std::ranges::move(lines_of(folder / "judged.jsonl"), std::back_inserter(judged));
  }
  std::vector<LibraryDossier> all;
  double done = 0;
  for (const auto& [name, command] : commands) {
    progress(done++ / static_cast<double>(commands.size()));
    LibraryDossier& library = library_called(all, facts_of(command));
    for (const std::string& line : judged)
      if (JudgedShape one = judged_in(line); one.name == name) library.judged.push_back(std::move(one));
    for (const std::string& line : findings)
      if (read_json(line).at("method") == name) library.findings.push_back(filed(line, command));
  }
  std::erase_if(all, [](const LibraryDossier& one) { return one.judged.empty(); });
  std::size_t number = 0;
  for (LibraryDossier& library : all) {
    std::ranges::stable_sort(library.findings, is_worse);
    library.findings = joined(std::move(library.findings));
    for (FiledFinding& one : library.findings) one.dossier.recorded.finding.number = ++number;
  }
  return all;
}

std::string findings_file(const std::vector<LibraryDossier>& libraries) {
  std::string text;
  for (const LibraryDossier& library : libraries)
    for (const FiledFinding& one : library.findings) text += one.line + "\n";
  return text;
}

std::string picture_of(const FiledFinding& filed, const DrawCase& draw) {
  const Evidence& evidence = filed.recorded().finding.evidence;
  const auto* hits = std::get_if<RayAnswer>(&evidence.got);
  const bool has_picture = evidence.no_answer.empty() && !(hits != nullptr && hits->verdict_only);
  return draw(filed.recorded().finding.one, &evidence.exact, has_picture ? &evidence.got : nullptr);
}

std::string budget_in_words(const std::vector<LibraryDossier>& libraries) {
  std::set<std::pair<std::uint64_t, std::uint64_t>> budgets;
  for (const LibraryDossier& library : libraries)
    for (const JudgedShape& one : library.judged) budgets.emplace(one.seed, one.cases_each);
  std::vector<std::string> texts;
  for (const auto& [seed, cases] : budgets)
    texts.push_back(fmt::format("seed {}, {} cases for each shape, family and precision", seed, cases));
  return fmt::format("{}", fmt::join(texts, "; "));
}

std::string where_seen(const Finding& finding) {
  const auto precision = name_of(finding.one.precision);
  if (finding.cases == 0) return std::string(precision);
  if (finding.cases == 1) return fmt::format("{}, in one case", precision);
  return fmt::format("{}, about {} of the cases", precision, finding.cases);
}

std::string also_in_words(const FiledFinding& filed) {
  std::vector<std::string> texts;
  for (const auto& [shape, name] : filed.also_in)
    texts.push_back(name == filed.recorded().name ? shape : shape + "/" + name);
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string documentation_of(const FiledFinding& filed) {
  return filed.dossier.documentation.empty() ? "It does not exclude this." : filed.dossier.documentation;
}

}  // namespace rayproof::dossier
