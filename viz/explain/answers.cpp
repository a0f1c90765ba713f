#include "viz/explain/case_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "viz/trace/numbers.hpp"

namespace rayproof::viz {
namespace {

std::string name_of(RootKind kind, std::size_t count) {
  if (count == 0 && (kind == RootKind::two || kind == RootKind::twice || kind == RootKind::linear)) {
    return "no root that is a number";
  }
  static constexpr std::array names{"two roots",        "a double root",       "no real root",
                                    "one root (a = 0)", "no root (a = b = 0)", "every number"};
  return names.at(static_cast<std::size_t>(kind));
}

std::string words_of(const RayAnswer& answer) {
  // Those of no words may be either.
  static constexpr std::array names{"",
                                    "",
                                    "hit on an edge",
                                    "hit on a vertex",
                                    "hit on the rim",
                                    "miss (in the surface)",
                                    "miss (parallel)",
                                    "miss (no area)",
                                    ""};
  const std::string name = names.at(static_cast<std::size_t>(answer.contact));
  if (!name.empty()) return name;
  if (answer.hits.count == 0) return "miss";
  return answer.contact == Contact::tangent ? "tangent hit" : "hit";
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

/// One hit where there are two, and it is the second.
bool is_farther_alone(const std::vector<double>& truth, const std::vector<double>& claim) {
  return truth.size() == 2 && claim.size() == 1 &&
         std::abs(claim[0] - truth[1]) < std::abs(claim[0] - truth[0]);
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
  const std::optional<ValuePair> pair = worst_pair(exact, claimed, precision);
  return pair ? pair->ulps : 0;
}

std::optional<ValuePair> worst_pair(const Answer* exact, const Answer* claimed, Precision precision) {
  const std::vector<double> truth = values_of(exact);
  const std::vector<double> claim = values_of(claimed);
  std::optional<ValuePair> worst;
  for (std::size_t i = 0; i < std::min(truth.size(), claim.size()); ++i) {
    const double ulps = count_ulps(truth[i], claim[i], precision);
    if (!worst || ulps > worst->ulps) worst = {i, truth[i], claim[i], ulps};
  }
  return worst;
}

std::string headline_of(const Case& one, const Answer* exact, const Answer* claimed) {
  if (claimed == nullptr) return fmt::format("Exact answer: {}", verdict_of(exact));
  if (exact == nullptr) return fmt::format("Claimed answer: {}", verdict_of(claimed));
  const bool is_farther = is_farther_alone(values_of(exact), values_of(claimed));
  const std::optional<ValuePair> worst = worst_pair(exact, claimed, one.precision);
  std::string remark;
  if (is_farther || verdicts_differ(exact, claimed)) {
    remark = ", which is wrong";
  } else if (worst && worst->ulps > 0) {
    const std::string apart = apart_in_words(worst->exact, worst->claimed, one.precision);
    remark = std::isinf(worst->ulps) ? ", " + apart + " off" : ", off by " + apart;
  }
  const std::string claim = is_farther ? "the farther hit alone" : verdict_of(claimed);
  return fmt::format("Exact: {}. Claimed: {}{}.", verdict_of(exact), claim, remark);
}

}  // namespace rayproof::viz
