#include "properties/report/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "properties/report/grid.hpp"
#include "subjects/subject.hpp"

namespace rayproof {

namespace {

/// From what a reader must see to what says nothing.
constexpr std::array by_weight{ClaimStatus::broken,   ClaimStatus::unrefuted, ClaimStatus::refuted,
                               ClaimStatus::holds,    ClaimStatus::spared,    ClaimStatus::untested,
                               ClaimStatus::unclaimed};

std::size_t weight_of(ClaimStatus status) {
  return static_cast<std::size_t>(std::find(by_weight.begin(), by_weight.end(), status) - by_weight.begin());
}

/// The claims that some row has a mark for.
std::vector<Claim> claims_in_use(const Summary& summary) {
  std::vector<Claim> used;
  for (std::size_t c = 0; c < claim_count; ++c)
    if (std::any_of(summary.rows.begin(), summary.rows.end(), [&](const Row& row) {
          return status_of(row, static_cast<Claim>(c)) != ClaimStatus::unclaimed;
        }))
      used.push_back(static_cast<Claim>(c));
  return used;
}

/// The rows of each method, in the order of the summary.
std::vector<std::vector<const Row*>> by_method(const Summary& summary) {
  std::vector<std::vector<const Row*>> methods;
  for (const Row& row : summary.rows) {
    if (methods.empty() || methods.back().front()->subject != row.subject) methods.emplace_back();
    methods.back().push_back(&row);
  }
  return methods;
}

std::string signs_of(const std::vector<const Row*>& rows, Claim claim) {
  std::string signs;
  for (const Row* row : rows) {
    const std::string sign = text_of(status_of(*row, claim)).sign;
    if (sign != signs) signs += sign;
  }
  return signs;
}

/// "26841 of 207169"; nothing where no error was measured.
std::string wrong_verdicts(const std::vector<const Row*>& rows) {
  Worst worst;
  for (const Row* row : rows) worst += row->worst;
  return worst.cases == 0 ? "" : fmt::format("{} of {}", worst.wrong, worst.cases);
}

std::string legend() {
  std::string text;
  for (const ClaimStatus status : statuses_in_legend)
    text += fmt::format("{}{} {}", text.empty() ? "" : "   ", text_of(status).sign, text_of(status).words);
  return text + "\n";
}

}  // namespace

std::array<std::string, 2> head_of(Claim claim) {
  const std::string name(claim_name(claim));
  static const std::map<Claim, std::size_t> breaks{
      {Claim::verdict, 3},  {Claim::residual, 4}, {Claim::robust, 2}, {Claim::ascending, 6},
      {Claim::reversed, 2}, {Claim::bounded, 5},  {Claim::contact, 3}};
  const auto found = breaks.find(claim);
  if (found == breaks.end()) return {"", name};
  return {name.substr(0, found->second) + "-", name.substr(found->second)};
}

ClaimStatus status_of(const Row& row, Claim claim) {
  ClaimStatus status = ClaimStatus::unclaimed;
  for (const Cell& cell : row.cells)
    if (cell.property->claim == claim && weight_of(cell.status) < weight_of(status)) status = cell.status;
  return status;
}

std::string text_table(const Summary& summary) {
  const std::vector<Claim> claims = claims_in_use(summary);
  Grid grid(1);
  std::array<std::vector<std::string>, 2> head{{{""}, {"method"}}};
  for (const Claim claim : claims)
    for (std::size_t line = 0; line < 2; ++line) head.at(line).push_back(head_of(claim).at(line));
  head[0].emplace_back("wrong verdicts,");
  head[1].emplace_back("in the domain");
  for (const auto& line : head) grid.add(line);
  for (const auto& rows : by_method(summary)) {
    std::vector<std::string> line{rows.front()->subject->full_name()};
    for (const Claim claim : claims) line.push_back(signs_of(rows, claim));
    line.push_back(wrong_verdicts(rows));
    grid.add(line);
  }
  return grid.rows() + legend();
}

}  // namespace rayproof
