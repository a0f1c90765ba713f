#include "viz/explain/case_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "viz/trace/numbers.hpp"

namespace rayproof::viz {
namespace {

std::string name_of(RootKind kind, std::size_t count) {
  if (count == 0 && (kind == RootKind::two || kind == RootKind::twice || kind == RootKind::linear)) {
    return "no root that is a number";
  }
  switch (kind) {
    case RootKind::two:
      return "two roots";
    case RootKind::twice:
      return "a double root";
    case RootKind::none:
      return "no real root";
    case RootKind::linear:
      return "one root (a = 0)";
    case RootKind::constant:
      return "no root (a = b = 0)";
    case RootKind::everything:
      return "every number";
  }
  return "";
}

std::string words_of(const RayAnswer& answer) {
  const bool is_hit = answer.hits.count > 0;
  switch (answer.contact) {
    case Contact::tangent:
      return is_hit ? "tangent hit" : "miss";
    case Contact::edge:
      return "hit on an edge";
    case Contact::vertex:
      return "hit on a vertex";
    case Contact::rim:
      return "hit on the rim";
    case Contact::in_surface:
      return "miss (in the surface)";
    case Contact::parallel:
      return "miss (parallel)";
    case Contact::degenerate:
      return "miss (no area)";
    default:
      return is_hit ? "hit" : "miss";
  }
}

/// Two misses, each with a reason, and not the same.
bool reasons_differ(const Answer& exact, const Answer& claimed) {
  const auto* truth = std::get_if<RayAnswer>(&exact);
  const auto* claim = std::get_if<RayAnswer>(&claimed);
  if (truth == nullptr || claim == nullptr || truth->hits.count + claim->hits.count > 0) return false;
  return truth->contact != Contact::none && claim->contact != Contact::none &&
         truth->contact != claim->contact;
}
std::string words_of(const QuadraticAnswer<double>& answer) { return name_of(answer.kind, answer.count); }

std::string words_of(Position position) { return rayproof::name_of(position); }

int kind_of(Position position) { return static_cast<int>(position); }
int kind_of(const RayAnswer& answer) { return answer.hits.count > 0 ? 1 : 0; }
int kind_of(const QuadraticAnswer<double>& answer) { return static_cast<int>(answer.kind); }

std::vector<double> list_of(Position /*has no numbers*/) { return {}; }
std::vector<double> list_of(const RayAnswer& answer) {
  const auto hits = answer.hits.view();
  return {hits.begin(), hits.end()};
}
std::vector<double> list_of(const QuadraticAnswer<double>& answer) {
  return {answer.roots.begin(), answer.roots.begin() + static_cast<std::ptrdiff_t>(answer.count)};
}

}  // namespace

std::vector<double> values_of(const Answer* answer) {
  if (answer == nullptr) return {};
  return std::visit([](const auto& one) { return list_of(one); }, *answer);
}

std::string verdict_of(const Answer* answer) {
  if (answer == nullptr) return "not given";
  return std::visit([](const auto& one) { return words_of(one); }, *answer);
}

bool verdicts_differ(const Answer* exact, const Answer* claimed) {
  if (exact == nullptr || claimed == nullptr) return false;
  const auto kind = [](const Answer& answer) {
    return std::visit([](const auto& one) { return kind_of(one); }, answer);
  };
  if (kind(*exact) != kind(*claimed) || reasons_differ(*exact, *claimed)) return true;
  const auto* ray_answer = std::get_if<RayAnswer>(claimed);
  const bool lists_all = ray_answer == nullptr || !ray_answer->nearest_only;
  return lists_all && values_of(exact).size() != values_of(claimed).size();
}

double worst_ulps(const Answer* exact, const Answer* claimed, Precision precision) {
  const std::vector<double> truth = values_of(exact);
  const std::vector<double> claim = values_of(claimed);
  double worst = 0;
  for (std::size_t i = 0; i < std::min(truth.size(), claim.size()); ++i) {
    worst = std::max(worst, count_ulps(truth[i], claim[i], precision));
  }
  return worst;
}

std::string headline_of(const Case& one, const Answer* exact, const Answer* claimed) {
  if (claimed == nullptr) return fmt::format("Exact answer: {}", verdict_of(exact));
  if (exact == nullptr) return fmt::format("Claimed answer: {}", verdict_of(claimed));
  std::string remark;
  const double ulps = worst_ulps(exact, claimed, one.precision);
  if (verdicts_differ(exact, claimed)) {
    remark = ", which is wrong";
  } else if (ulps > 0) {
    remark = fmt::format(", {}", accuracy_in_words(ulps));
  }
  return fmt::format("Exact: {}. Claimed: {}{}.", verdict_of(exact), verdict_of(claimed), remark);
}

}  // namespace rayproof::viz
