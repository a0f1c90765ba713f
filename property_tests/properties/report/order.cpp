#include "properties/report/findings.hpp"

#include <algorithm>

#include "case/writer.hpp"
#include "properties/engine/plan.hpp"

namespace rayproof {

namespace {

/// A wrong verdict is one kind of failure, a wrong number another, and every other claim is a kind of its
/// own.
std::string_view kind_of(const Property& property) {
  if (property.name == "robust-verdict") return "verdict";
  if (property.name == "robust-residual" || property.claim == Claim::ulp) return "residual";
  return property.name;
}

/// What is wrong where nothing is rounded, and declared so, is not a failure of its own.
bool is_wrong_exactly(const Finding& one) { return one.is_declared && one.property->name == "exact"; }

/// Why the contract says that the method fails there; nothing where it says that it does not.
std::string_view reason(const Finding& one) {
  const Refutation* declared = declared_refutation(*one.subject, *one.property);
  return one.is_declared && declared != nullptr ? declared->because : std::string_view();
}

/// What breaks a symmetry shows less than what is wrong by itself.
bool is_of_symmetry(const Finding& one) {
  const Claim claim = one.property->claim;
  return claim == Claim::scaled || claim == Claim::reversed || claim == Claim::moved;
}

bool is_same_failure(const Finding& a, const Finding& b) {
  if (is_wrong_exactly(a) && a.subject == b.subject && b.is_declared) return true;
  const bool has_one_reason = !reason(a).empty() && reason(a) == reason(b);
  const bool is_as_printed = a.subject->contract.standing == Standing::printed;
  if (a.subject == b.subject && is_as_printed && a.is_declared && b.is_declared) return true;
  // One fault breaks several properties, and several faults break one.
  const bool have_causes = !a.is_declared && !b.is_declared && a.cause != nullptr && b.cause != nullptr;
  if (have_causes && a.subject == b.subject) return a.cause == b.cause;
  if (kind_of(*a.property) != kind_of(*b.property)) return false;
  if (!a.is_declared && a.cause != b.cause) return false;
  if (a.subject == b.subject) return true;
  // Each formula as printed has an entry of its own, and so has each broken contract.
  const auto stands_alone = [](const Finding& one) {
    return !one.is_declared || one.subject->contract.standing == Standing::printed;
  };
  if (stands_alone(a) || stands_alone(b) || a.subject->topic != b.subject->topic) return false;
  return has_one_reason || (write_case(a.one) == write_case(b.one) && in_words(a) == in_words(b));
}

}  // namespace

std::vector<std::vector<Finding>> alike(const std::vector<Finding>& findings, bool is_declared) {
  std::vector<std::vector<Finding>> groups;
  const auto put = [&](const Finding& finding) {
    const auto group = std::ranges::find_if(groups, [&](const std::vector<Finding>& some) {
      return std::ranges::any_of(some, [&](const Finding& other) { return is_same_failure(finding, other); });
    });
    if (group == groups.end()) {
      groups.push_back({finding});
    } else {
      group->push_back(finding);
    }
  };
  for (const bool is_exact : {false, true})
    for (const Finding& finding : findings)
      if (finding.is_declared == is_declared && is_wrong_exactly(finding) == is_exact) put(finding);
  if (!is_declared)
    for (std::vector<Finding>& group : groups) std::ranges::stable_sort(group, {}, is_of_symmetry);
  return groups;
}

void put_in_order(std::vector<Finding>& findings) {
  std::vector<Finding> ordered;
  for (const bool is_declared : {false, true})
    for (const std::vector<Finding>& group : alike(findings, is_declared))
      ordered.insert(ordered.end(), group.begin(), group.end());
  for (std::size_t i = 0; i < ordered.size(); ++i) ordered[i].number = i + 1;
  findings = std::move(ordered);
}

}  // namespace rayproof
