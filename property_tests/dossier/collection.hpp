#pragma once
/// \file
/// The findings of one or several checks by library, with what was judged.

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dossier/bug_report.hpp"
#include "properties/report/report.hpp"

namespace rayproof::dossier {

/// What was judged of one subject on one shape.
struct JudgedShape {
  std::string shape{}, name{};
  std::uint64_t seed = 0, cases_each = 0;  ///< of the check: cases for each family and precision
  std::uint64_t cases = 0, unsupported = 0, failures = 0;
  std::vector<std::pair<std::string, std::uint64_t>> claims{};  ///< how many cases were judged by each
  std::string not_judged{};

  [[nodiscard]] std::uint64_t answered() const { return cases - unsupported - failures; }
};

/// A finding with all that is known of it; where the library could not be asked again, `trouble` says why.
struct FiledFinding {
  Dossier dossier{};
  std::string line{};  ///< of the findings file
  std::string trouble{};
  /// Where else the same function has this diagnosis, by shape and subject: one fault of the library is one
  /// finding.
  std::vector<std::pair<std::string, std::string>> also_in{};

  [[nodiscard]] const RecordedFinding& recorded() const { return dossier.recorded; }
  [[nodiscard]] std::pair<std::string, std::string> place() const {
    return {recorded().shape, recorded().name};
  }
  [[nodiscard]] bool is_of(const JudgedShape& judged) const {
    const std::pair other(judged.shape, judged.name);
    return place() == other || std::ranges::find(also_in, other) != also_in.end();
  }
};

/// Everything on one library.
struct LibraryDossier {
  LibraryFacts facts{};
  std::vector<JudgedShape> judged{};
  std::vector<FiledFinding> findings{};  ///< the worst kind first
};

/// What the folders of checks hold, in the order of the registry of subjects; findings are numbered anew
/// from 1. Libraries are asked again about each finding. Throws std::runtime_error with one sentence.
///
/// \param commands the name of each subject and the shell line of its program
[[nodiscard]] std::vector<LibraryDossier> collect(
    const std::vector<std::filesystem::path>& folders,
    const std::vector<std::pair<std::string, std::string>>& commands,
    const std::function<void(double)>& progress);

/// Keeps of each fault its first finding, with the cases and the places of the others: findings of one
/// subject, or of one function, with one diagnosis are one fault, unless nothing was found to cure them.
[[nodiscard]] std::vector<FiledFinding> joined(std::vector<FiledFinding> findings);

/// The lines of all findings, in the order of their numbers.
[[nodiscard]] std::string findings_file(const std::vector<LibraryDossier>& libraries);

/// Draws a case with its exact and its claimed answer as one element of HTML.
using DrawCase = std::function<std::string(const Case& one, const Answer* exact, const Answer* claimed)>;

/// The picture of a finding, as check's own page has it.
[[nodiscard]] std::string picture_of(const FiledFinding& filed, const DrawCase& draw);

/// A page that needs nothing but the pictures' script beside it.
[[nodiscard]] std::string findings_page(const std::vector<LibraryDossier>& libraries, const PageTools& tools);

/// The same as Markdown; pictures are files of a folder that it names `images/findings/N.svg`.
[[nodiscard]] std::string findings_markdown(const std::vector<LibraryDossier>& libraries,
                                            const std::string& command);

/// "seed 2022, 2000 cases for each shape, family and precision".
[[nodiscard]] std::string budget_in_words(const std::vector<LibraryDossier>& libraries);

/// In what precision, and in how many of the run's cases, where those were counted: what ends a program is
/// not.
[[nodiscard]] std::string where_seen(const Finding& finding);
/// "box, sphere/bullet-gjk": where else the fault shows; subjects are named where they are others.
[[nodiscard]] std::string also_in_words(const FiledFinding& filed);

/// What the documentation says of the fault, as a sentence.
[[nodiscard]] std::string documentation_of(const FiledFinding& filed);

}  // namespace rayproof::dossier
