#include "properties/engine/kind.hpp"

#include <algorithm>
#include <cmath>

#include "properties/diagnosis/examination/agreement.hpp"
#include "properties/guests/guest.hpp"

namespace rayproof {
namespace {

/// Beyond 2^±28, where a cube of a float overflows before it is judged wrong.
constexpr int ordinary = 28;
/// An error below this share of what it is an error of is a loss of digits.
constexpr double small_share = 1e-3;
/// A verdict this near to its change, in shares of the scene's size, is a matter of the boundary.
constexpr double near_boundary = 1e-6;

bool has_extreme_numbers(Case one) {
  const std::vector<CaseNumber> numbers = numbers_of(one);
  return std::ranges::any_of(numbers, [](const CaseNumber& number) {
    const double size = std::abs(*number.value);
    return size != 0 && std::isfinite(size) && std::abs(std::log2(size)) > ordinary;
  });
}

/// Whether two vectors are the same but for the last digits; where one is left out nothing can be compared.
bool is_near(const std::optional<glm::dvec3>& got, const std::optional<glm::dvec3>& exact) {
  return got && exact && glm::length(*got - *exact) <= small_share * std::max(1.0, glm::length(*exact));
}

bool is_rounding_of_hit(Claim claim, const Evidence& evidence) {
  const auto* got = std::get_if<RayAnswer>(&evidence.got);
  const auto* exact = std::get_if<RayAnswer>(&evidence.exact);
  if (got == nullptr || exact == nullptr) return false;
  return (claim == Claim::point && is_near(got->point, exact->point)) ||
         (claim == Claim::normal && is_near(got->normal, exact->normal)) ||
         (claim == Claim::coordinates && is_near(got->barycentric, exact->barycentric));
}

/// Whether a point is off the surface only because t is rounded too coarsely, which the other finding says.
bool is_point_of_coarse_t(const Finding& finding, const Finding& other) {
  const auto loses_digits = [](const Finding& one) {
    return one.cause != nullptr && one.cause->kind == FindingKind::rounding;
  };
  return finding.property->name == "point-on-surface" && other.property->claim == Claim::residual &&
         loses_digits(finding) && loses_digits(other);
}

/// Whether what is answered to the case of a finding that no model foresees is foreseen by the other's model:
/// of the cases that it does not foresee there is none that is as simple.
bool is_foreseen_by(const Finding& finding, const Finding& other) {
  const Hypothesis& model = *other.cause;
  const OfSizes sizes = finding.cause->of_sizes;
  const bool may_follow = finding.cause->predict == nullptr || sizes == OfSizes::small ||
                          sizes == OfSizes::limit || finding.property->name == "digits";
  const bool says_the_same = sizes != OfSizes::nothing && sizes == model.of_sizes;
  if (!may_follow || model.predict == nullptr || model.is_one_of_many || says_the_same) return false;
  const Answer &got = finding.evidence.got, &exact = finding.evidence.exact;
  if (!finding.evidence.no_answer.empty() || breaks_symmetry(finding)) return false;
  return std::ranges::any_of(model.predict(finding.one, exact), [&](const Answer& foreseen) {
    // What the model leaves open is the subject's, right or wrong: a normal, where it says nothing of
    // normals.
    const auto agrees = [&](const Answer& answer) {
      return diagnosis::agree(finding.one, answer, diagnosis::as_reported(foreseen, answer), model.aspect);
    };
    return agrees(got) && !agrees(exact);
  });
}

/// Whether the other says that answers depend on more than the case: a model fits some of them by chance.
bool is_of_doubtful_answers(const Finding& finding, const Finding& other) {
  return finding.property == other.property && other.cause->asked != Asking::in_turn &&
         finding.cause->asked == Asking::in_turn && finding.cases <= other.cases;
}

/// Whether a normal is wrong in fewer cases than a gross fault of the hits, in far fewer where a model of
/// normals foresees it: what else is wrong with the shape that is taken.
bool is_normal_of_wrong_shape(const Finding& finding, const Finding& other) {
  const bool is_foreseen = finding.cause->change == nullptr && !finding.cause->is_vague;
  const std::uint64_t times = finding.property->every * (is_foreseen ? 8 : 1);
  const bool is_of_all_hits =
      other.cause->kind == FindingKind::gross || other.cause->kind == FindingKind::rounding;
  const bool is_of_hits =
      other.cause->aspect == Aspect::hits && is_of_all_hits && other.property->claim != Claim::normal;
  return finding.property->claim == Claim::normal && is_of_hits && !other.cause->is_vague &&
         times * finding.cases <= other.cases;
}

FindingKind kind_of_case(const Finding& finding) {
  const Evidence& evidence = finding.evidence;
  const Claim claim = finding.property->claim;
  if (claim == Claim::answers) return FindingKind::protocol;
  if (claim == Claim::nan) return FindingKind::gross;
  const Case& one = evidence.other ? *evidence.other : finding.one;
  if (claim == Claim::exact) return FindingKind::boundary;
  if (finding.property->name == "digits") return FindingKind::rounding;
  const oracle::Judgement judgement = judged(one, evidence.got);
  const double share = roundoff_of(one.precision);
  const bool is_at_boundary = judgement.wrong && judgement.margin * share <= near_boundary;
  if (is_at_boundary || claim == Claim::contact) return FindingKind::boundary;
  if (has_extreme_numbers(one)) return FindingKind::range;
  const bool is_near_t = !judgement.wrong && judgement.residual * share <= small_share;
  if ((claim == Claim::point || claim == Claim::normal || claim == Claim::coordinates))
    return is_rounding_of_hit(claim, evidence) ? FindingKind::rounding : FindingKind::gross;
  return is_near_t && claim != Claim::ascending ? FindingKind::rounding : FindingKind::gross;
}

}  // namespace

FindingKind kind_of(const Finding& finding) {
  const FindingKind by_case = kind_of_case(finding);
  if (!finding.kind_of_fault || by_case == FindingKind::protocol) return by_case;
  if (finding.kind_of_fault != FindingKind::gross) return *finding.kind_of_fault;
  // A cure may help where digits are lost, too; a model foresees no rounding. The simplest case may lie near
  // a boundary though most do not.
  const bool is_model = finding.cause != nullptr && finding.cause->change == nullptr;
  const bool may_be_gross = finding.property->claim != Claim::exact && by_case != FindingKind::range;
  return (is_model || finding.is_beyond_rounding) && may_be_gross ? FindingKind::gross : by_case;
}

bool is_named_boundary(const Finding& finding) {
  const Hypothesis* cause = finding.cause;
  return cause != nullptr && cause->change == nullptr && cause->kind == FindingKind::boundary;
}

bool is_zero_alone(const Finding& finding) {
  return finding.property->claim == Claim::exact && finding.cause != nullptr &&
         finding.cause->of_sizes == OfSizes::small;
}

bool is_part_of(const Finding& finding, const Finding& other) {
  if (finding.cause == nullptr || other.cause == nullptr) return false;
  if (is_normal_of_wrong_shape(finding, other) || is_point_of_coarse_t(finding, other)) return true;
  if (!other.cause->is_vague && other.cases >= finding.cases && is_foreseen_by(finding, other)) return true;
  if (is_of_doubtful_answers(finding, other)) return true;
  if (finding.cause->follows_from == other.cause->name && !other.cause->name.empty()) return true;
  const std::string_view stem = stem_of_limit(other.cause->name);
  if (!stem.empty() && finding.cause->follows_from == stem && finding.cases <= other.cases) return true;
  const bool is_known_at_extremes_alone = finding.cause->of_sizes == OfSizes::extremes;
  const std::uint64_t most = finding.cause->is_vague ? 2 * other.cases : other.cases;
  if (finding.cases > most && !is_known_at_extremes_alone) return false;
  const bool is_model =
      other.cause->change == nullptr && !other.cause->is_vague && other.cause->kind == FindingKind::gross;
  const bool is_alike = finding.cause->aspect == other.cause->aspect;
  return (finding.cause->is_vague && is_alike && is_model) || is_part_of(*finding.cause, *other.cause);
}

bool is_extreme(const Finding& finding) { return has_extreme_numbers(finding.one); }

bool is_avoided(const Finding& finding) {
  const Hypothesis* cause = finding.cause;
  return cause != nullptr && cause->change != nullptr && cause->keeps == Keeps::verdict && !cause->perturbs;
}

}  // namespace rayproof
