#pragma once
/// \file
/// Hypotheses on what is wrong with a subject: models, which foresee its wrong answers, and cures, which
/// change the case until the answer is right.

#include <optional>
#include <string_view>
#include <vector>

#include "case/answer.hpp"
#include "case/case.hpp"
#include "properties/finding_kind.hpp"

namespace rayproof {

/// The part of an answer that a fault shows in.
enum class Aspect { hits, contact, point, normal, coordinates };

/// What must stay the same of a case that a cure changes: a cure that avoids the question is none.
enum class Keeps {
  question,  ///< verdict, number of hits, contact, and whether a hit lies on an end of the interval
  verdict    ///< hit stays hit, miss stays miss
};

/// How a case is asked to see whether the answers depend on more than the case.
enum class Asking {
  in_turn,  ///< as all others
  alone,    ///< of a program that has been asked nothing before
  again     ///< a second time
};

/// What a fault has to do with the sizes of numbers: of two findings one may be a part of the other.
enum class OfSizes {
  nothing,
  zero,     ///< a hit is missed where a number is exactly 0
  small,    ///< what is small is taken for 0; then 0 is, too
  limit,    ///< right up to some size
  type,     ///< a type of fewer digits, which has a smaller range, too
  extremes  ///< right at ordinary sizes: no more is known
};

/// The answers that a subject with this fault may give to the case; none where the fault does not show.
using Predict = std::vector<Answer> (*)(const Case& one, const Answer& exact);
/// Whether an answer bears the fault's mark; nothing where the fault does not show in this case.
using Recognise = std::optional<bool> (*)(const Case& one, const Answer& got, const Answer& exact);
/// Other cases, the mildest change first, on one of which the subject is right if it has this fault; none
/// where the cure is not for this case.
using Change = std::vector<Case> (*)(const Case& one);

/// How large the mistake is that an answer shows, of a fault that has a size, as a factor has: 0 where the
/// answer is right though the fault would show; nothing where it shows nothing.
using SizeOfMistake = std::optional<double> (*)(const Case& one, const Answer& got, const Answer& exact);
/// The answers that a subject may give whose mistake has that size.
using PredictOfSize = std::vector<Answer> (*)(const Case& one, const Answer& exact, double size);

/// One line of the registry. Exactly one of predict, recognise, measure and change is there.
struct Hypothesis {
  std::string_view name{};      ///< "unit-direction"
  FindingKind kind{};           ///< where nothing speaks for another one
  std::string_view sentence{};  ///< what is wrong, in words
  Aspect aspect = Aspect::hits;
  Predict predict = nullptr;
  Recognise recognise = nullptr;
  SizeOfMistake measure = nullptr;          ///< all cases that it explains show about one size
  PredictOfSize predict_of_size = nullptr;  ///< beside measure, where an answer shows no size
  bool is_factor = false;                   ///< what is measured is a factor less 1
  Change change = nullptr;
  Keeps keeps = Keeps::question;
  /// The changed case differs in more than powers of two: no proof where any small change cures.
  bool perturbs = true;
  Asking asked = Asking::in_turn;
  /// A cure of hits that are lost, not of what is found where there is nothing, or too soon.
  bool is_of_lost_hits = false;
  bool is_pair = false;        ///< of two cures at once
  bool speaks_of_all = false;  ///< of every form of a shape, whatever forms the failing cases have
  /// Of what fits single cases by chance: the percentage of a sample that it must explain; else 0.
  std::size_t least_share = 0;
  /// How many right answers may contradict it, in percent of the cases that it explains: by other faults, and
  /// by luck.
  std::size_t admits = 12;
  /// A cure that must help, too, in most of what a model explains; empty where none need be.
  std::string_view confirmed_by{};
  /// The name of a model from which this one follows: where that is found, too, it alone is shown.
  std::string_view follows_from{};
  std::string_view of_equation{};  ///< the sentence where the cases are quadratic equations, if it is another
  std::string_view of_point{};     ///< the same of points in polygons
  OfSizes of_sizes = OfSizes::nothing;
  /// It only says where to look: a cure that helps against many a fault that a model may name, or a mark that
  /// many bear.
  bool is_vague = false;
  /// Of a cure of digits: the sentence where most cases are wronger than rounding can make them. Where there
  /// is none the cure explains no such case.
  std::string_view beyond_rounding{};
  /// Of a model that says more than another one: one case at least that it explains must show that.
  bool (*shows_more)(const Case& one, const Answer& exact) = nullptr;
  /// Of a model whose numbers differ by precision: complaints of one precision take them for another size.
  bool differs_by_precision = false;
  /// Of a mark of all that is said: what is said of the first hit bears it, too, and lost digits alone.
  bool is_throughout = false;
  /// Of a model that foresees many answers, always in the same order: one of these must explain all cases.
  bool is_one_of_many = false;
  /// It says that nothing is ever found: of a subject of which that is so it alone is believed.
  bool is_of_no_hits = false;
};

/// What a name has in common with those of other limits, "epsilon" of "epsilon-1e-4"; empty where it is of
/// none.
[[nodiscard]] constexpr std::string_view stem_of_limit(std::string_view name) {
  const std::size_t end = name.rfind("-1e");
  return end == std::string_view::npos ? std::string_view{} : name.substr(0, end);
}

/// Whether the first says no more than a part of what the second says.
[[nodiscard]] constexpr bool is_part_of(const Hypothesis& part, const Hypothesis& whole) {
  const OfSizes own = part.of_sizes, other = whole.of_sizes;
  if (own == OfSizes::zero) return other == OfSizes::small;
  // A cure says only that something small is taken for 0, a model says what.
  if (own == OfSizes::small && other == own) return part.change != nullptr && whole.change == nullptr;
  if (own == OfSizes::extremes)
    return other == OfSizes::small || other == OfSizes::limit || other == OfSizes::type;
  return (own == OfSizes::small || own == OfSizes::limit) && other == OfSizes::type;
}

/// Hypotheses on one matter: models, or cures.
struct HypothesisTable {
  std::string_view title{};
  std::vector<Hypothesis> lines{};
};

/// The registry. Of two hypotheses that explain as much the first is taken.
[[nodiscard]] const std::vector<HypothesisTable>& hypothesis_tables();
/// All of them, in that order.
[[nodiscard]] const std::vector<Hypothesis>& hypotheses();

/// The hypothesis of that name, or null.
[[nodiscard]] const Hypothesis* find_hypothesis(std::string_view name);

}  // namespace rayproof
