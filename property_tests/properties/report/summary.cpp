#include "properties/report/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rayproof {

namespace {

/// Whether a guest breaks the property by a fault whose finding stands at another property or precision: one
/// fault is one finding (guests/one_fault.cpp).
bool is_broken_elsewhere(const RunResult& result, const Row& row, const Cell& cell) {
  return !row.subject->has_own_contract && cell.tally.broken > 0 &&
         std::ranges::any_of(result.findings,
                             [&](const Finding& finding) { return finding.subject == row.subject; });
}

ClaimStatus status_of(const Plan& plan, const RunResult& result, const Row& row, const Cell& cell) {
  const bool was_found =
      find_finding(result, row, *cell.property) != nullptr || is_broken_elsewhere(result, row, cell);
  if (claims(*row.subject, *cell.property)) {
    if (was_found) return ClaimStatus::broken;
    return cell.tally.judged() > 0 ? ClaimStatus::holds : ClaimStatus::untested;
  }
  if (!is_declared_refuted(*row.subject, *cell.property)) return ClaimStatus::unclaimed;
  if (was_found) return ClaimStatus::refuted;
  const bool was_claim_refuted = std::ranges::any_of(properties(), [&](const Property& property) {
    return property.claim == cell.property->claim && find_finding(result, row, property) != nullptr;
  });
  if (was_claim_refuted) return ClaimStatus::spared;
  // Only a full search for a counterexample may be held against the declaration.
  const bool searched_in_full = plan.settings.families.empty() && !result.was_interrupted;
  return searched_in_full ? ClaimStatus::unrefuted : ClaimStatus::untested;
}

/// Adds up a row's figures over the families.
void add_up(const RunResult& result, Row& row) {
  Tally sum;
  for (const Unit& unit : result.units) {
    if (unit.subject != row.subject || unit.precision != row.precision) continue;
    sum += unit.tally;
    if (unit.tally.worst.transformed == 0) row.worst += unit.tally.worst;
  }
  row.cases = sum.cases;
  for (std::size_t p = 0; p < row.cells.size() && p < sum.properties.size(); ++p)
    row.cells[p].tally = sum.properties[p];
}

}  // namespace

const StatusText& text_of(ClaimStatus status) {
  static constexpr StatusText texts[] = {
      {"", "not claimed", "mark"},
      {"–", "not tested", "mark"},
      {"·", "not broken", "mark"},
      {"✓", "holds", "mark holds"},
      {"‡", "refuted as declared", "mark refuted"},
      {"?", "declared broken, NOT REFUTED", "mark broken"},
      {"✗", "BROKEN", "mark broken"},
  };
  return texts[static_cast<std::size_t>(status)];
}

Summary summarise(const Plan& plan, const RunResult& result) {
  Summary summary;
  summary.was_interrupted = result.was_interrupted;
  for (const Subject* subject : plan.subjects)
    for (const Precision precision : plan.precisions) {
      Row row{subject, precision};
      for (const Property& property : properties()) row.cells.push_back({&property});
      add_up(result, row);
      for (std::size_t p = 0; p < row.cells.size(); ++p)
        if (plan.is_wanted[p]) row.cells[p].status = status_of(plan, result, row, row.cells[p]);
      summary.rows.push_back(std::move(row));
    }
  for (const LabelCount& labels : result.labels)
    for (const std::string& sentence : labels.missed())
      summary.missed_shares.push_back(fmt::format("{} {}", name_of(labels.precision), sentence));
  return summary;
}

std::vector<std::string> Summary::sentences(std::initializer_list<ClaimStatus> statuses) const {
  std::vector<std::string> all;
  for (const Row& row : rows)
    for (const Cell& cell : row.cells)
      if (std::ranges::find(statuses, cell.status) != statuses.end())
        all.push_back(fmt::format("{} {}: {}: {}", row.subject->full_name(), name_of(row.precision),
                                  cell.property->name, text_of(cell.status).words));
  all.insert(all.end(), missed_shares.begin(), missed_shares.end());
  return all;
}

const Finding* find_finding(const RunResult& result, const Row& row, const Property& property) {
  const auto found = std::ranges::find_if(result.findings, [&](const Finding& finding) {
    return finding.subject == row.subject && finding.one.precision == row.precision &&
           finding.property == &property;
  });
  return found == result.findings.end() ? nullptr : &*found;
}

std::string figure(double measured) {
  if (measured == 0) return "0";
  if (!std::isfinite(measured)) return measured > 0 ? "inf" : "nan";
  return measured >= 0.01 && measured < 1000 ? fmt::format("{:.3g}", measured)
                                             : fmt::format("{:.1e}", measured);
}

std::string figure(double measured, double promised) {
  return std::isfinite(promised) ? figure(measured) + " of " + figure(promised) : figure(measured);
}

}  // namespace rayproof
