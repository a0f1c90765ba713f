#include "properties/engine/plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "case/reader/near_names.hpp"
#include "subjects/subject.hpp"

namespace rayproof {

namespace {

/// Refuses the first of `wanted` that `known` lacks.
void check_names(const char* what, const std::vector<std::string>& wanted,
                 const std::set<std::string>& known) {
  for (const std::string& name : wanted)
    if (!known.contains(name))
      throw UnknownName(fmt::format("there is no {} \"{}\"{}", what, name,
                                    names_instead(name, {known.begin(), known.end()})));
}

bool is_wanted(const std::vector<std::string>& wanted, std::initializer_list<std::string_view> names) {
  return wanted.empty() || std::ranges::find_first_of(wanted, names) != wanted.end();
}

void check_all_names(const Settings& settings, const std::vector<Subject>& all_subjects) {
  std::set<std::string> shapes, methods, family_names, property_names;
  std::vector<std::string> wanted_methods = settings.methods;
  for (const Subject& subject : all_subjects) {
    shapes.insert(subject.topic);
    methods.insert(subject.full_name());
    std::ranges::replace(wanted_methods, subject.name, subject.full_name());
  }
  for (const Family& family : families()) family_names.insert(family.name);
  for (const Property& property : properties()) {
    property_names.emplace(property.name);
    property_names.emplace(claim_name(property.claim));
  }
  check_names("shape", settings.shapes, shapes);
  check_names("method", wanted_methods, methods);
  check_names("family", settings.families, family_names);
  check_names("property", settings.properties, property_names);
}

}  // namespace

bool claims(const Subject& subject, const Property& property) {
  return subject.contract.holds.contains(property.claim);
}

const Refutation* declared_refutation(const Subject& subject, const Property& property) {
  for (const Refutation& one : subject.contract.refuted)
    if (!one.because.empty() && one.claim == property.claim) return &one;
  return nullptr;
}

void expect_claimed(const Plan& plan) {
  const Settings& settings = plan.settings;
  if (settings.properties.empty()) return;
  const auto is_judged = [&](const std::vector<std::string>& methods,
                             const std::vector<std::string>& wanted) {
    for (const Subject* subject : plan.subjects)
      for (const Property& one : properties())
        if (is_wanted(methods, {subject->name, subject->full_name()}) &&
            is_wanted(wanted, {one.name, claim_name(one.claim)}) &&
            (claims(*subject, one) || is_declared_refuted(*subject, one)))
          return true;
    return false;
  };
  constexpr const char* more = "there is nothing to check; rayproof methods --json has what each claims";
  for (const std::string& method : settings.methods)
    if (!is_judged({method}, settings.properties))
      throw UnknownName(
          fmt::format("{} does not claim {}: {}", method, fmt::join(settings.properties, " or "), more));
  for (const std::string& property : settings.properties)
    if (!is_judged({}, {property}))
      throw UnknownName(fmt::format("no method that is asked for claims {}: {}", property, more));
}

Plan make_plan(const Settings& settings, const std::vector<Subject>& all_subjects) {
  check_all_names(settings, all_subjects);
  Plan plan{settings, {}, {}, {}, settings.precisions, {}};
  if (plan.precisions.empty()) plan.precisions = {Precision::float32, Precision::float64};
  for (const Subject& subject : all_subjects)
    if (is_wanted(settings.shapes, {subject.topic}) &&
        is_wanted(settings.methods, {subject.name, subject.full_name()}))
      plan.subjects.push_back(&subject);
  for (const Family& family : families())
    if (is_wanted(settings.families, {family.name}) &&
        std::ranges::find(plan.subjects, family.topic, &Subject::topic) != plan.subjects.end())
      plan.families.push_back(&family);
  for (const Property& property : properties())
    plan.is_wanted.push_back(is_wanted(settings.properties, {property.name, claim_name(property.claim)}));
  if (plan.subjects.empty() || plan.families.empty())
    throw UnknownName(
        "no method and family are left to check: --shape, --method and --family exclude each other");
  return plan;
}

}  // namespace rayproof
