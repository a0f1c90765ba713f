#include "bench/figures/choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "bench/figures/median.hpp"
#include "subjects/subject.hpp"

namespace rayproof::report {

namespace {

constexpr double twice_the_price = 2;

Scenes scenes_of(const std::string& family) {
  if (family == "random") return Scenes::near_by;
  if (family == "far") return Scenes::from_afar;
  return family == "transformed" || family == "placed" ? Scenes::transformed : Scenes::hard;
}

const Contract* own_contract(const std::string& shape, const std::string& method) {
  const auto found = std::ranges::find_if(
      subjects(), [&](const Subject& one) { return one.topic == shape && one.name == method; });
  return found != subjects().end() && found->has_own_contract ? &found->contract : nullptr;
}

bool is_sound(const BenchRow& row) {
  const Contract* contract = own_contract(row.shape, row.method);
  return contract != nullptr && contract->standing == Standing::sound;
}

/// NaN where no hit is agreed on, or where there are none: a point is inside or not.
double bits_of(const MethodSummary& one) {
  return std::isnan(one.accuracy.mean_bits) ? 0 : one.accuracy.mean_bits;
}

/// Half an ulp, and what its own measurement rounds.
bool is_exact(const MethodSummary& one) { return one.wrong_share() == 0 && !(one.accuracy.max_ulp > 0.501); }

/// The methods of one shape and precision on one kind of scenes.
Choice choice_among(Scenes scenes, std::vector<MethodSummary> methods) {
  std::ranges::sort(methods, std::less{}, &MethodSummary::ns_per_ray);
  Choice choice{.scenes = scenes, .fastest = methods.front(), .closest = methods.front()};
  for (const MethodSummary& one : methods) {
    const auto error = [](const MethodSummary& some) {
      return std::tuple(some.wrong_share(), bits_of(some));
    };
    const bool is_expensive = one.ns_per_ray > twice_the_price * choice.fastest.ns_per_ray;
    if (!is_expensive && error(one) < error(choice.closest)) choice.closest = one;
    if (!choice.exact && is_exact(one)) choice.exact = one;
  }
  return choice;
}

/// The median over the families of what the oracle costs for such cases.
std::optional<double> oracle_in(const std::vector<BenchRow>& rows, const Choice& choice) {
  std::vector<double> times;
  for (const BenchRow& row : rows)
    if (row.method == oracle_name && row.shape == choice.fastest.shape &&
        row.precision == choice.fastest.precision && is_of_scenes(row.family) &&
        scenes_of(row.family) == choice.scenes)
      times.push_back(row.ns_per_ray);
  return times.empty() ? std::nullopt : std::optional(median(std::move(times)));
}

}  // namespace

const char* name_of(Scenes scenes) {
  switch (scenes) {
    case Scenes::near_by:
      return "near by";
    case Scenes::from_afar:
      return "from afar";
    case Scenes::transformed:
      return "transformed";
    case Scenes::hard:
      break;
  }
  return "hard cases";
}

std::vector<Choice> choose(const std::vector<BenchRow>& rows) {
  std::vector<Choice> all;
  for (const Scenes scenes : {Scenes::near_by, Scenes::from_afar, Scenes::transformed, Scenes::hard}) {
    std::vector<BenchRow> own;
    std::ranges::copy_if(rows, std::back_inserter(own), [&](const BenchRow& row) {
      return is_of_scenes(row.family) && scenes_of(row.family) == scenes && is_sound(row);
    });
    std::vector<MethodSummary> methods = summarise(own);
    while (!methods.empty()) {
      const auto is_of_others = [first = methods.front()](const MethodSummary& one) {
        return one.shape != first.shape || one.precision != first.precision;
      };
      std::vector<MethodSummary> group = methods, others = methods;
      std::erase_if(group, is_of_others);
      std::erase_if(others, std::not_fn(is_of_others));
      methods = std::move(others);
      const auto is_batch = [](const MethodSummary& one) { return one.arrangement == Arrangement::batch; };
      if (std::ranges::any_of(group, is_batch)) std::erase_if(group, std::not_fn(is_batch));
      all.push_back(choice_among(scenes, std::move(group)));
    }
  }
  for (Choice& one : all) one.oracle_ns = oracle_in(rows, one);
  const auto place = [&](const Choice& one) {
    const auto same_shape = [&](const BenchRow& row) { return row.shape == one.fastest.shape; };
    return std::tuple(std::ranges::find_if(rows, same_shape) - rows.begin(), one.fastest.precision,
                      one.scenes);
  };
  std::ranges::sort(all, std::less{}, place);
  return all;
}

std::string guarantee_of(const MethodSummary& method) {
  const Contract* contract = own_contract(method.shape, method.method);
  if (contract == nullptr) return "none";
  if (contract->holds.contains(Claim::rounded)) return "verdict exact, t rounded once: proven";
  const Bound& verdict = contract->verdict;
  if (verdict.promised == 0) return "verdict exact: proven";
  if (verdict.is_proven) return fmt::format("verdict within {:g} units: proven", verdict.promised);
  return fmt::format("verdict within {:g} units; worst found {:.3g}", verdict.promised, verdict.measured);
}

}  // namespace rayproof::report
