#include "leaks/text.hpp"

#include <fmt/format.h>

#include "case/writer.hpp"
#include "properties/report/grid.hpp"

namespace rayproof::leaks {

namespace {

constexpr std::size_t as_number(AimedAt target) { return static_cast<std::size_t>(target); }

/// "12 of 3400"; "-" where no ray was aimed there.
std::string share(std::uint64_t count, std::uint64_t rays) {
  return rays == 0 ? "-" : fmt::format("{} of {}", count, rays);
}

/// What was not judged of a subject's answers, in a line each.
std::string not_judged(const Outcomes& one) {
  std::string text;
  const std::string who = fmt::format("{} {}", one.subject->full_name(), name_of(one.precision));
  if (one.unsupported > 0) text += fmt::format("{}: {} rays are not for it, it says\n", who, one.unsupported);
  if (one.failed > 0)
    text += fmt::format("{}: {} rays without an answer{}\n", who, one.failed,
                        one.failure ? ": " + one.failure->second : "");
  if (one.subject->is_given_up()) text += fmt::format("{}: given up: {}\n", who, one.subject->why_given_up());
  return text;
}

}  // namespace

std::string text_table(const Result& result) {
  Rows rows{{"subject", "precision", "leaks at vertices", "midpoints", "edges", "diagonals", "from inside",
             "double hits"}};
  for (const Outcomes& one : result.outcomes) {
    std::vector<std::string> row{one.subject->full_name(), name_of(one.precision)};
    for (const AimedAt target : {AimedAt::vertex, AimedAt::midpoint, AimedAt::edge, AimedAt::diagonal})
      row.push_back(share(one.leaks.at(as_number(target)), one.rays.at(as_number(target))));
    row.push_back(fmt::format("{}", one.leaks_from_inside));
    row.push_back(fmt::format("{}", one.total(one.doubles)));
    rows.push_back(row);
  }
  std::string text = in_columns(rows, 2, true);
  for (const Outcomes& one : result.outcomes) text += not_judged(one);
  return text;
}

std::vector<std::string> broken_promises(const Result& result) {
  std::vector<std::string> sentences;
  for (const Outcomes& one : result.outcomes) {
    if (!is_held_to(*one.subject) || one.total(one.leaks) + one.total(one.doubles) + one.failed == 0)
      continue;
    sentences.push_back(fmt::format("{} in {}: {} leaks and {} double hits{}", one.subject->full_name(),
                                    name_of(one.precision), one.total(one.leaks), one.total(one.doubles),
                                    one.failed > 0 ? fmt::format(", {} rays without an answer", one.failed)
                                    : one.subject->has_own_contract ? ", though it is sound"
                                                                    : ""));
  }
  return sentences;
}

std::string case_lines(const Result& result) {
  std::string lines;
  for (const Outcomes& one : result.outcomes)
    for (const std::optional<Loss>& loss : one.first) {
      if (!loss) continue;
      for (std::size_t k = 0; k < loss->cases.size(); ++k) {
        Case noted = loss->cases[k];
        noted.note =
            fmt::format("{} of {}, triangle {} of the mesh, ray {}: {} by this triangle, {} in truth",
                        failure_names.at(static_cast<std::size_t>(loss->failure)), one.subject->full_name(),
                        loss->aim.patch[k], loss->number, loss->got[k].empty() ? "a miss" : "a hit",
                        loss->is_hit[k] ? "a hit" : "a miss");
        lines += write_case(noted) + "\n";
      }
    }
  return lines;
}

}  // namespace rayproof::leaks
