#include "properties/report/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "properties/report/grid.hpp"
#include "subjects/subject.hpp"

namespace rayproof {

namespace {

/// In which column a claim stands: `rounded` says what `ulp` says, more strictly, `conservative` half of what
/// `verdict` says.
Claim column_of(Claim claim) {
  if (claim == Claim::conservative) return Claim::verdict;
  return claim == Claim::rounded ? Claim::ulp : claim;
}

/// The status of a row in a claim's column, which several properties may serve: the one that matters most.
ClaimStatus status_of(const Row& row, Claim claim) {
  ClaimStatus status = ClaimStatus::unclaimed;
  for (const Cell& cell : row.cells)
    if (column_of(cell.property->claim) == claim) status = std::max(status, cell.status);
  return status;
}

/// The claims that some row has a mark for.
std::vector<Claim> claims_in_use(const Summary& summary) {
  std::vector<Claim> used;
  for (std::size_t c = 0; c < claim_count; ++c)
    if (std::ranges::any_of(summary.rows, [&](const Row& row) {
          return status_of(row, static_cast<Claim>(c)) != ClaimStatus::unclaimed;
        }))
      used.push_back(static_cast<Claim>(c));
  return used;
}

/// The line of a method: its name, the mark for each claim (two where the precisions differ), and
/// "26841 of 207169" wrong verdicts, or nothing where no error was measured.
std::vector<std::string> line_of(const Subject& subject, const std::vector<Row>& rows,
                                 const std::vector<Claim>& claims) {
  std::vector<std::string> line{subject.full_name()};
  line.resize(claims.size() + 1);
  Worst worst;
  for (const Row& row : rows) {
    if (row.subject != &subject) continue;
    worst += row.worst;
    for (std::size_t c = 0; c < claims.size(); ++c)
      if (const char* const sign = text_of(status_of(row, claims[c])).sign; line[c + 1] != sign)
        line[c + 1] += sign;
  }
  line.push_back(worst.cases == 0 ? "" : fmt::format("{} of {}", worst.wrong, worst.cases));
  return line;
}

}  // namespace

std::array<std::string_view, 3> head_of(Claim claim) {
  static constexpr std::array<std::array<std::string_view, 3>, claim_count> heads{{{"ver-", "di-", "ct"},
                                                                                   {"re-", "si-", "dual"},
                                                                                   {"", "", "ulp"},
                                                                                   {"ro-", "un-", "ded"},
                                                                                   {"ro-", "bu-", "st"},
                                                                                   {"as-", "cen-", "ding"},
                                                                                   {"", "mo-", "ved"},
                                                                                   {"", "sca-", "led"},
                                                                                   {"re-", "ver-", "sed"},
                                                                                   {"", "ba-", "tch"},
                                                                                   {"", "", "nan"},
                                                                                   {"bo-", "un-", "ded"},
                                                                                   {"", "con-", "tact"},
                                                                                   {"", "po-", "int"},
                                                                                   {"", "nor-", "mal"},
                                                                                   {"co-", "ordi-", "nates"},
                                                                                   {"", "ex-", "act"},
                                                                                   {"con-", "serv-", "ative"},
                                                                                   {"an-", "swe-", "rs"}}};
  return heads.at(static_cast<std::size_t>(claim));
}

std::string text_table(const Summary& summary) {
  const std::vector<Claim> claims = claims_in_use(summary);
  Rows rows{{""}, {""}, {"method"}};
  for (const Claim claim : claims)
    for (std::size_t line = 0; line < 3; ++line) rows[line].emplace_back(head_of(claim).at(line));
  rows[0].emplace_back();
  rows[1].emplace_back("wrong verdicts,");
  rows[2].emplace_back("in the domain");
  if (std::ranges::all_of(rows.front(), &std::string::empty)) rows.erase(rows.begin());
  const Subject* last = nullptr;
  for (const Row& row : summary.rows)
    if (std::exchange(last, row.subject) != row.subject)
      rows.push_back(line_of(*row.subject, summary.rows, claims));
  std::vector<std::string> legend;
  legend.reserve(statuses_in_legend.size());
  for (const ClaimStatus status : statuses_in_legend)
    legend.push_back(fmt::format("{} {}", text_of(status).sign, text_of(status).words));
  return fmt::format("{}{}\n", in_columns(rows, 1, false), fmt::join(legend, "   "));
}

}  // namespace rayproof
