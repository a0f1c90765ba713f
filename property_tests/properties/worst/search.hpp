#pragma once
/// \file
/// Guided search: for the worst case of each method, of each of its errors.

#include "properties/engine/plan.hpp"
#include "properties/finding.hpp"
#include "properties/worst/climb.hpp"

namespace rayproof::worst {

/// What to search. `plan` has the methods, families, precisions, seed and number of threads; cases and time
/// are for each method at each precision.
struct WorstSearch {
  Settings plan{};
  std::optional<std::chrono::duration<double>> time{};  ///< in place of a number of cases
  bool compare = false;                                 ///< search by draws alone, too, as long
};

/// The worst of one kind of error of one method.
struct WorstRow {
  const Subject* subject = nullptr;
  Precision precision{};
  std::size_t kind = 0;
  std::optional<double> drawn{};     ///< the worst that draws alone found; nothing where they were not asked
  std::optional<WorstCase> found{};  ///< nothing where no error was met
  std::optional<WorstCase> exceeding{};  ///< the worst case, or the worst draw, where it breaks a promise

  [[nodiscard]] const Bound& bound() const { return measure_of(kind).bound(subject->contract); }
  /// What is promised of cases as of this row: under a transform no less than the robust bound (promise.hpp).
  [[nodiscard]] double promised() const;
  /// Whether that is proven.
  [[nodiscard]] bool is_proven() const;
  /// "residual", "residual, transformed".
  [[nodiscard]] std::string error_name() const;
};

/// What came of a search.
struct WorstResult {
  std::vector<WorstRow> rows{};
  std::uint64_t climbed = 0, drawn = 0;  ///< cases, all in all
  bool was_interrupted = false;

  [[nodiscard]] bool keeps_promises() const;
};

/// Hears the share of the whole search that is done, and what is being searched.
using HearSearch = std::function<void(double, const std::string&)>;

/// Searches method after method; the misprinted ones where they are named. The worst cases of a method are
/// offered to the next ones of its shape. Of a method that is stopped, what was found counts. Throws
/// UnknownName as make_plan does.
[[nodiscard]] WorstResult search(const WorstSearch& what, const std::atomic<bool>& stop,
                                 const HearSearch& progress);

/// The worst case of a row as a finding: what `replay`, `explain`, `draw` and `walk` take.
[[nodiscard]] Finding finding_of(const WorstRow& row, std::size_t number);

/// The rows as a table, and a sentence for each promise that is exceeded.
[[nodiscard]] std::string text_table(const WorstResult& result);
[[nodiscard]] std::string text_exceeded(const WorstResult& result);

/// The same as one JSON object.
[[nodiscard]] std::string json_text(const WorstSearch& what, const WorstResult& result);

}  // namespace rayproof::worst
