#include "properties/guests/one_fault.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "properties/shrink/shrink.hpp"

namespace rayproof {

namespace {

bool is_of_guest(const Finding& finding) { return !finding.subject->has_own_contract; }

/// Whether anything at all is known of the subject beside what its twins show.
bool has_direct_finding(const std::vector<Finding>& findings, const Subject* subject) {
  return std::ranges::any_of(findings, [&](const Finding& one) {
    return one.subject == subject && !breaks_symmetry(one) && one.property->claim != Claim::answers;
  });
}

/// Whether it speaks of verdict and t, which one fault may break in several ways.
bool is_of_hits(const Finding& finding) {
  const Claim claim = finding.property->claim;
  return finding.property->name != "digits" && claim != Claim::point && claim != Claim::normal &&
         claim != Claim::coordinates && claim != Claim::contact;
}

/// What makes two findings one: the cause, whatever its limit, or, where none is known, what they speak of.
auto fault_of(const Finding& finding) {
  const bool is_one = finding.cause != nullptr || is_of_hits(finding);
  const std::string_view cause =
      finding.cause == nullptr ? std::string_view{} : name_without_limit(*finding.cause);
  return std::tuple(finding.subject, cause, is_one ? nullptr : finding.property);
}

/// What went wrong without its numbers, and without what the program said of it: two findings of the protocol
/// that share it are one.
std::string trouble_in(const Finding& finding) {
  std::string text = finding.evidence.no_answer.substr(0, finding.evidence.no_answer.find(';'));
  std::erase_if(text, [](char c) { return '0' <= c && c <= '9'; });
  return text;
}

/// The one that is shown: the gravest; of these what speaks of hits, from which wrong details follow, and the
/// simplest.
bool is_better(const Finding& one, const Finding& other, KindOf gravity, const CauseSays& says) {
  const auto rank = [&](const Finding& some) {
    return std::tuple(says.is_zero_alone(some), gravity(some), some.property->name == "digits",
                      !is_of_hits(some), complexity(some.one));
  };
  return rank(one) < rank(other);
}

/// Findings of several properties are about the same cases, those of two precisions about others.
std::uint64_t cases_of(const std::vector<const Finding*>& alike) {
  std::map<Precision, std::uint64_t> most;
  for (const Finding* one : alike) {
    std::uint64_t& cases = most[one->one.precision];
    cases = std::max(cases, one->cases);
  }
  std::uint64_t sum = 0;
  for (const auto& [precision, cases] : most) sum += cases;
  return sum;
}

/// Whether it says of boundaries only what a gross fault of more cases does there, too, or one of sizes.
bool is_boundary_of_more(const Finding& finding, const std::vector<Finding>& all, KindOf gravity,
                         const CauseSays& says) {
  return finding.property->name == "boundary" && !says.is_named(finding) &&
         std::ranges::any_of(all, [&](const Finding& one) {
           return one.subject == finding.subject && one.cause != nullptr && one.cases >= finding.cases &&
                  (gravity(one) == FindingKind::gross || gravity(one) == FindingKind::range);
         });
}

/// Whether it says no more than that cases near a boundary, or isolated ones, are wrong, where many more
/// cases show a fault as bad or worse: where rounding decides, that one shows in ways that no model foresees.
bool is_fringe_of_more(const Finding& finding, const std::vector<Finding>& all, KindOf gravity,
                       const CauseSays& says) {
  constexpr std::uint64_t many_more = 4;
  return says.is_avoided(finding) && std::ranges::any_of(all, [&](const Finding& one) {
           return one.subject == finding.subject && one.cause != finding.cause &&
                  one.cases >= many_more * finding.cases && gravity(one) <= gravity(finding);
         });
}

/// Whether another finding of the subject says more of the same: what takes small numbers for 0 misses what
/// is 0, too.
bool is_part_of_other(const Finding& finding, const std::vector<Finding>& all, const CauseSays& says) {
  return std::ranges::any_of(
      all, [&](const Finding& one) { return one.subject == finding.subject && says.is_part(finding, one); });
}

/// Whether it says no more than that digits are lost, of a subject of which more is known; or where it does
/// not say why, and another finding does.
bool is_lost_in_more(const Finding& finding, const std::vector<Finding>& all, const CauseSays& says) {
  const auto says_more = [&](const Finding& one) {
    if (one.property == finding.property && finding.cause == nullptr) return one.cause != nullptr;
    if (one.property == finding.property)
      return says.is_avoided(finding) && !says.is_avoided(one) && one.cause != nullptr &&
             one.cases >= finding.cases;
    return one.property->claim != Claim::answers && (finding.cause == nullptr || one.cause == finding.cause);
  };
  return finding.property->name == "digits" && std::ranges::any_of(all, [&](const Finding& one) {
           return one.subject == finding.subject && says_more(one);
         });
}

/// Whether there is no answer, as a NaN, only where numbers are so large or small that the subject is known
/// to be wrong there. That there is none elsewhere is shown, whatever else is wrong.
bool is_overflow_of_more(const Finding& finding, const std::vector<Finding>& all, KindOf gravity,
                         const CauseSays& says) {
  return says.is_extreme(finding) && std::ranges::any_of(all, [&](const Finding& one) {
           return one.subject == finding.subject && gravity(one) == FindingKind::range;
         });
}

/// Whether a known cause of the same subject does as much harm: what is left without a cause is mostly its
/// work. What loses digits does so in cases of which the cause that is known is not found.
bool is_overshadowed(const Finding& finding, const std::vector<Finding>& all, KindOf gravity) {
  // An epsilon that shows at small sizes shows on boundaries, too.
  const auto is_size_of_boundary = [&](const Finding& one) {
    return gravity(finding) == FindingKind::boundary && gravity(one) == FindingKind::range;
  };
  return finding.cause == nullptr && std::ranges::any_of(all, [&](const Finding& one) {
           return one.subject == finding.subject && one.cause != nullptr &&
                  (gravity(one) <= gravity(finding) || is_size_of_boundary(one)) &&
                  (one.cases >= finding.cases || gravity(one) == FindingKind::rounding);
         });
}

}  // namespace

void leave_out_twins(std::vector<Finding>& findings) {
  std::vector<Finding> kept;
  for (Finding& one : findings)
    if (!is_of_guest(one) || !breaks_symmetry(one) || !has_direct_finding(findings, one.subject))
      kept.push_back(one);
  findings = std::move(kept);
}

void put_together(std::vector<Finding>& findings, KindOf gravity, const CauseSays& says) {
  std::vector<Finding> kept;
  std::map<decltype(fault_of(findings.front())), std::vector<const Finding*>> faults;
  for (const Finding& one : findings)
    if (is_of_guest(one) && one.property->claim != Claim::answers) faults[fault_of(one)].push_back(&one);
  std::set<std::pair<const Subject*, std::string>> troubles;
  for (const Finding& one : findings) {
    const auto alike = faults.find(fault_of(one));
    if (one.property->claim == Claim::answers) {
      if (troubles.insert({one.subject, trouble_in(one)}).second) kept.push_back(one);
      continue;
    }
    if (alike == faults.end()) {
      kept.push_back(one);
      continue;
    }
    if (alike->second.front() != &one) continue;
    Finding fault = **std::ranges::min_element(
        alike->second, [&](const Finding* a, const Finding* b) { return is_better(*a, *b, gravity, says); });
    fault.cases = cases_of(alike->second);
    kept.push_back(std::move(fault));
  }
  const std::vector<Finding> all = kept;
  std::erase_if(kept, [&](const Finding& one) {
    if (one.property->claim == Claim::answers) return is_overflow_of_more(one, all, gravity, says);
    return is_of_guest(one) &&
           (is_overshadowed(one, all, gravity) || is_boundary_of_more(one, all, gravity, says) ||
            is_fringe_of_more(one, all, gravity, says) || is_part_of_other(one, all, says) ||
            is_lost_in_more(one, all, says));
  });
  findings = std::move(kept);
}

}  // namespace rayproof
