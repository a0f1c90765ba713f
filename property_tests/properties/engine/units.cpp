#include "properties/engine/units.hpp"

#include <algorithm>
#include <map>

namespace rayproof {

/// The subject on the family, with the properties of the plan that it claims or is declared to break. The
/// worst errors are measured where one of these measures an error, so that they cost nothing more.
static Unit unit_of(const Plan& plan, const Subject& subject, const Family& family, Precision precision) {
  Unit unit{&subject, &family, precision, {}, plan.settings.measure_all};
  for (std::size_t p = 0; p < plan.is_wanted.size(); ++p) {
    const Property& property = properties()[p];
    if (!plan.is_wanted[p] || !(claims(subject, property) || is_declared_refuted(subject, property)))
      continue;
    unit.tested.push_back(p);
    unit.measure = unit.measure || property.excess != nullptr;
  }
  return unit;
}

/// Whether a subject is asked cases of the family.
static bool is_asked(const Plan& plan, const Subject& subject, const Family& family) {
  const bool is_for_all = !family.is_beyond_the_digits || !plan.settings.families.empty();
  return family.topic == subject.topic && (is_for_all || subject.has_own_contract);
}

std::vector<Unit> units_of(const Plan& plan) {
  std::vector<Unit> units;
  for (const Subject* subject : plan.subjects)
    for (const Precision precision : plan.precisions)
      for (const Family* family : plan.families)
        if (is_asked(plan, *subject, *family)) units.push_back(unit_of(plan, *subject, *family, precision));
  return units;
}

std::vector<std::reference_wrapper<Unit>> by_families(std::vector<Unit>& units) {
  std::vector<std::reference_wrapper<Unit>> sorted(units.begin(), units.end());
  std::map<std::pair<const Family*, Precision>, std::size_t> rank;
  for (const Unit& unit : units) rank.emplace(std::pair(unit.family, unit.precision), rank.size());
  std::ranges::stable_sort(sorted, {}, [&](const Unit& unit) {
    return rank.at({unit.family, unit.precision});
  });
  return sorted;
}

}  // namespace rayproof
