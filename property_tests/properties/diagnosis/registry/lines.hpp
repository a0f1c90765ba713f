#pragma once
/// \file
/// What the lines of the registry are made by.

#include <fmt/format.h>

#include <deque>
#include <string>

#include "properties/diagnosis/registry.hpp"

namespace rayproof::diagnosis {

inline constexpr auto gross = FindingKind::gross;
inline constexpr auto boundary = FindingKind::boundary;
inline constexpr auto rounding = FindingKind::rounding;

/// Words that are made of a number, kept as long as the program runs.
[[nodiscard]] inline std::string_view kept(std::string words) {
  static std::deque<std::string> all;
  return all.emplace_back(std::move(words));
}

/// A subject that gives these answers.
[[nodiscard]] constexpr Hypothesis gives(std::string_view name, Predict predict, std::string_view sentence,
                                         FindingKind kind = gross, Aspect aspect = Aspect::hits) {
  return {.name = name, .kind = kind, .sentence = sentence, .aspect = aspect, .predict = predict};
}

/// One that must explain this share of a sample, in percent: single cases fit it by chance.
[[nodiscard]] constexpr Hypothesis of_share(std::size_t percent, Hypothesis model) {
  model.least_share = percent;
  return model;
}

/// One that this share of right answers may contradict, in percent of the cases that it explains.
[[nodiscard]] constexpr Hypothesis admitting(std::size_t percent, Hypothesis model) {
  model.admits = percent;
  return model;
}

/// A model that fits single cases by chance.
[[nodiscard]] constexpr Hypothesis gives_to_all(std::string_view name, Predict predict,
                                                std::string_view sentence) {
  return of_share(90, gives(name, predict, sentence));
}

/// The same of one that fits large numbers, too, which few rounded digits leave as they are.
[[nodiscard]] constexpr Hypothesis gives_to_most(std::string_view name, Predict predict,
                                                 std::string_view sentence) {
  return of_share(60, gives(name, predict, sentence));
}

/// A model that stands for many mistakes, of which a subject makes one.
[[nodiscard]] constexpr Hypothesis gives_one_of(std::string_view name, Predict predict,
                                                std::string_view sentence, FindingKind kind = gross,
                                                Aspect aspect = Aspect::hits) {
  Hypothesis made = gives(name, predict, sentence, kind, aspect);
  made.is_one_of_many = true;
  return made;
}

/// The same of a model that foresees misses mostly, which many a fault makes: hardly any right answer may
/// contradict it.
[[nodiscard]] constexpr Hypothesis strictly(Hypothesis model) {
  model.speaks_of_all = true;
  return model;
}

/// The same of a model that says that nothing is ever found.
[[nodiscard]] constexpr Hypothesis of_no_hits(Hypothesis model) {
  model.is_of_no_hits = true;
  return model;
}

/// A subject whose answers bear this mark.
[[nodiscard]] constexpr Hypothesis shows(std::string_view name, Recognise recognise,
                                         std::string_view sentence, FindingKind kind = gross,
                                         Aspect aspect = Aspect::hits) {
  return {.name = name, .kind = kind, .sentence = sentence, .aspect = aspect, .recognise = recognise};
}

/// A subject whose mistake has one size in all cases, which is measured.
[[nodiscard]] constexpr Hypothesis has_one_size(std::string_view name, SizeOfMistake measure,
                                                std::string_view sentence, PredictOfSize predict = nullptr) {
  return {.name = name,
          .kind = gross,
          .sentence = sentence,
          .measure = measure,
          .predict_of_size = predict,
          .least_share = 40};
}

/// The same of a factor, of which what is more than 1 is measured.
[[nodiscard]] constexpr Hypothesis has_one_factor(std::string_view name, SizeOfMistake measure,
                                                  std::string_view sentence,
                                                  PredictOfSize predict = nullptr) {
  Hypothesis made = has_one_size(name, measure, sentence, predict);
  made.is_factor = true;
  return made;
}

/// A cure that changes nothing but powers of two, signs, or the order of things.
[[nodiscard]] constexpr Hypothesis exact_cure(std::string_view name, Change change, std::string_view sentence,
                                              FindingKind kind = gross, std::string_view of_equation = "") {
  return {.name = name,
          .kind = kind,
          .sentence = sentence,
          .change = change,
          .perturbs = false,
          .of_equation = of_equation};
}

/// A cure that rounds the case anew.
[[nodiscard]] constexpr Hypothesis cure(std::string_view name, Change change, std::string_view sentence,
                                        FindingKind kind = gross, Keeps keeps = Keeps::question) {
  return {.name = name, .kind = kind, .sentence = sentence, .change = change, .keeps = keeps};
}

/// The same of what only says where to look.
[[nodiscard]] constexpr Hypothesis vague(Hypothesis made) {
  made.is_vague = true;
  return made;
}

/// A cure of lost hits alone.
[[nodiscard]] constexpr Hypothesis of_lost_hits(Hypothesis cure) {
  cure.is_of_lost_hits = true;
  return cure;
}

/// A cure of digits that helps in other faults, too, of which the second sentence speaks.
[[nodiscard]] constexpr Hypothesis of_digits_or(std::string_view beyond_rounding, Hypothesis cure) {
  cure.beyond_rounding = beyond_rounding;
  return cure;
}

/// A model that says more than another one does: one case at least that it explains must show that.
[[nodiscard]] constexpr Hypothesis shown_by(bool (*shows_more)(const Case& one, const Answer& exact),
                                            Hypothesis made) {
  made.shows_more = shows_more;
  return made;
}

/// A model that follows from the one of that name.
[[nodiscard]] constexpr Hypothesis following(std::string_view other, Hypothesis made) {
  made.follows_from = other;
  return made;
}

/// The same with other words where the cases are quadratic equations.
[[nodiscard]] constexpr Hypothesis of_equation(std::string_view words, Hypothesis made) {
  made.of_equation = words;
  return made;
}

/// The same with other words where the cases are points in polygons.
[[nodiscard]] constexpr Hypothesis of_point(std::string_view words, Hypothesis made) {
  made.of_point = words;
  return made;
}

/// The same with what the fault has to do with sizes.
[[nodiscard]] constexpr Hypothesis of(OfSizes sizes, Hypothesis made) {
  made.of_sizes = sizes;
  return made;
}

/// A model of what is small taken for 0, below 10^power, for which there is a {} in the words.
[[nodiscard]] inline Hypothesis below_power(std::string_view name, int power, Predict predict,
                                            std::string_view words) {
  return of(OfSizes::small, gives(kept(fmt::format("{}-1e{}", name, power)), predict,
                                  kept(fmt::format(fmt::runtime(words), power))));
}

/// A hit that is left out where a number is exactly 0.
[[nodiscard]] constexpr Hypothesis misses_zero(std::string_view name, Predict predict,
                                               std::string_view sentence) {
  return of(OfSizes::zero, gives(name, predict, sentence, boundary));
}

/// A cure that avoids what only a boundary or a rounding can break.
[[nodiscard]] constexpr Hypothesis avoids(std::string_view name, Change change, std::string_view sentence,
                                          FindingKind kind = boundary) {
  return {.name = name,
          .kind = kind,
          .sentence = sentence,
          .change = change,
          .keeps = Keeps::verdict,
          .perturbs = false};
}

}  // namespace rayproof::diagnosis
