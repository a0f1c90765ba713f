#pragma once
/// \file
/// The subject's answers to the cases of a diagnosis, and how the hypotheses fit them.

#include <algorithm>
#include <array>

#include "properties/diagnosis/patient.hpp"
#include "properties/diagnosis/question.hpp"

namespace rayproof::diagnosis {

/// Of many mistakes that which explains most cases; of those that explain nearly as many, that which right
/// answers contradict least: of two limits of which both explain what is seen, the wider one.
template <class Explained, class Contradictions>
[[nodiscard]] std::size_t best_balanced(std::size_t mistakes, Explained&& explained,
                                        Contradictions&& contradictions) {
  std::vector<std::size_t> counts;
  for (std::size_t mistake = 0; mistake < mistakes; ++mistake) counts.push_back(explained(mistake));
  const std::size_t most = counts.empty() ? 0 : std::ranges::max(counts);
  std::size_t best = 0;
  std::optional<std::size_t> least;
  for (std::size_t mistake = 0; mistake < mistakes && most > 0; ++mistake) {
    if (10 * counts[mistake] < 9 * most) continue;
    const std::size_t against = contradictions(mistake);
    if (least && against >= *least) continue;
    least = against;
    best = mistake;
  }
  return best;
}

/// How a case puts its shape into the world: as it is, by a transform, or by one that mirrors.
enum class Placing { none, turned, mirrored };
[[nodiscard]] Placing placing_of(const Case& one);

/// Where a model's fault is seen, and where it is not though the model expects it.
struct SeenWhere {
  std::array<bool, 3> is_shown{};             ///< by placing: whether it explains a failing case
  std::array<std::size_t, 3> contradicted{};  ///< on how many passing cases it expects wrong answers

  SeenWhere& operator+=(const SeenWhere& more);
  /// Where alone the fault shows, in words; empty where it is not so. It may be made in the way of mirrored
  /// shapes alone, or of all that a transform places.
  [[nodiscard]] std::string_view condition() const;
};

/// The cases of a diagnosis with the subject's answers and the exact ones.
class Examination {
 public:
  Examination(const Patient& patient, std::span<const Case> failing, std::span<const Case> passing);

  /// Of a model that stands for many mistakes, or measures one, the number of one; nothing for that which
  /// explains most.
  using Mistake = std::optional<std::size_t>;

  /// The sizes of the mistake that these failing cases show, of a model that measures it.
  [[nodiscard]] std::vector<double> sizes_of(const Hypothesis& model,
                                             std::span<const std::size_t> cases) const;
  /// How many mistakes a model stands for in these failing cases.
  [[nodiscard]] std::size_t mistake_count(const Hypothesis& model, std::span<const std::size_t> cases) const;
  /// Which of these failing cases (by index) the hypothesis explains.
  [[nodiscard]] std::vector<std::size_t> explained(const Hypothesis& hypothesis,
                                                   std::span<const std::size_t> cases,
                                                   Mistake mistake = {}) const;
  /// On how many of the passing cases the hypothesis expects wrong answers where the subject's are right.
  /// Only cases of the same forms count as those of the failing cases that it explains: one form of a plane,
  /// say, or capped cylinders, may be all that is wrong. A cure is contradicted where it cures by silence:
  /// all that it makes right are misses, and of what is a hit it makes misses, too.
  [[nodiscard]] std::size_t contradictions(const Hypothesis& hypothesis,
                                           std::span<const std::size_t> explained,
                                           Mistake mistake = {}) const;
  /// Where the hypothesis is seen that explains these failing cases; nowhere if it is no model.
  [[nodiscard]] SeenWhere seen_where(const Hypothesis& hypothesis, std::span<const std::size_t> explained,
                                     Mistake mistake = {}) const;
  /// Whether one of the failing cases that a model explains shows all that it says.
  [[nodiscard]] bool is_shown_whole(const Hypothesis& model, std::span<const std::size_t> explained) const;
  /// In how many of these failing cases the verdict is right, and what is wrong is a number.
  [[nodiscard]] std::size_t count_of_numbers(std::span<const std::size_t> cases) const;
  /// Whether the ray runs along a plane, or a figure in one, in all of these failing cases.
  [[nodiscard]] bool run_along_surface(std::span<const std::size_t> cases) const;
  /// Whether the subject finds nothing in any of these failing cases.
  [[nodiscard]] bool finds_nothing(std::span<const std::size_t> cases) const;
  /// Whether it finds nothing in any case, failing or not.
  [[nodiscard]] bool never_finds() const;
  /// Whether the cases ask this: quadratic equations, points in polygons.
  template <class Question>
  [[nodiscard]] bool asks() const {
    return !failing_.empty() && std::holds_alternative<Question>(failing_.front().asked.one.question);
  }

  [[nodiscard]] std::size_t failing_count() const { return failing_.size(); }
  [[nodiscard]] std::size_t passing_count() const { return passing_.size(); }
  /// Whether the answer to a failing case is wronger than a loss of digits can make it.
  [[nodiscard]] bool is_beyond_rounding(std::size_t i) const;
  /// Of the failing cases, those on a boundary.
  [[nodiscard]] bool is_boundary_case(std::size_t i) const { return is_on_boundary(failing_.at(i).asked); }
  /// Whether all numbers of a failing case, its hits, and the lengths to them are of ordinary size, about
  /// 1e-3 to 1e3.
  [[nodiscard]] bool is_of_ordinary_size(std::size_t i) const;
  /// The largest relative error of the numbers in the answer to a failing case; infinite where the verdict is
  /// wrong.
  [[nodiscard]] double error_of(std::size_t i) const;

 private:
  struct Known {
    AnsweredCase asked;
    std::optional<Answer> got;
  };

  [[nodiscard]] std::vector<Known> ask(std::span<const Case> cases) const;
  /// A case that a cure has cured, and which of its changes did.
  struct Cured {
    std::size_t index, change;
  };
  [[nodiscard]] std::vector<Cured> cured(const Hypothesis& hypothesis,
                                         std::span<const std::size_t> cases) const;
  [[nodiscard]] bool is_confirmed(const Hypothesis& model, std::span<const std::size_t> explained) const;
  [[nodiscard]] std::size_t hits_lost(const Hypothesis& cure, std::span<const std::size_t> explained) const;
  [[nodiscard]] bool speaks_against(const Hypothesis& hypothesis, const Known& known, std::size_t mistake,
                                    bool finds_some) const;
  [[nodiscard]] static bool is_excused(const Hypothesis& hypothesis, const Known& known);
  [[nodiscard]] static bool has_lost_a_hit(const Known& known);
  /// The first of the cases to which the subject is right when it is asked each alone.
  [[nodiscard]] std::vector<std::size_t> cured_alone(std::span<const std::size_t> cases) const;
  /// Those of the cases to which the subject gives other numbers when it is asked again.
  [[nodiscard]] std::vector<std::size_t> changed_again(std::span<const std::size_t> cases) const;
  /// Whether a model's hypothesis fits an answer; nothing where it has nothing to say. Of a model that stands
  /// for many mistakes only the answer of that number is looked at.
  [[nodiscard]] std::optional<bool> fits(const Hypothesis& hypothesis, const Known& known,
                                         std::size_t mistake) const;
  /// What is looked at of a hypothesis' answers: where a detail of the first hit is claimed, that of a model
  /// which foresees whole answers.
  [[nodiscard]] Aspect aspect_of(const Hypothesis& hypothesis) const;
  [[nodiscard]] std::vector<std::size_t> explained_by(const Hypothesis& hypothesis,
                                                      std::span<const std::size_t> cases,
                                                      std::size_t mistake) const;
  /// Of the mistakes that a model stands for, that which explains most of the cases.
  [[nodiscard]] std::size_t best_mistake(const Hypothesis& hypothesis,
                                         std::span<const std::size_t> cases) const;

  const Patient& patient_;
  std::vector<Known> failing_;
  std::vector<Known> passing_;
};

}  // namespace rayproof::diagnosis
