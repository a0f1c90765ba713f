#pragma once
/// \file
/// The laboratory's cases for properties in rapidcheck's own style: generators that shrink to the case a
/// person reads most easily, and show it as one line of JSON.
///
///     RC_GTEST_PROP(MySphere, IsHitWhereASphereIs, ()) {
///       const Case one = *cases("sphere", "random");
///       RC_ASSERT(!oracle::judge(one, my_answer(one)).wrong);
///     }
///
/// docs/properties.md has a whole program.

#include <rapidcheck.h>

#include <cmath>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "case/writer.hpp"
#include "generators/generators.hpp"
#include "oracle/oracle.hpp"
#include "properties/engine/labels.hpp"
#include "properties/property.hpp"
#include "properties/shrink/shrink.hpp"

namespace rayproof {

/// How rapidcheck shows a case: as the line that every program of the laboratory reads.
inline void showValue(const Case& one, std::ostream& out) { out << write_case(one); }

/// The cases of a family; a failing one is shrunk as `rayproof check` shrinks it.
[[nodiscard]] inline rc::Gen<Case> cases(const Family& family, Precision precision = Precision::float32) {
  return [&family, precision](const rc::Random& random, int /*size*/) {
    rc::Random own = random;
    return rc::shrinkable::shrinkRecur(family.generate(own.next(), precision), [](const Case& one) {
      return rc::seq::fromContainer(simpler_cases(one));
    });
  };
}

/// The cases of the topic's family of that name, or of any of its families; throws std::invalid_argument
/// where there is none.
[[nodiscard]] inline rc::Gen<Case> cases(const std::string& topic, const std::string& family = {},
                                         Precision precision = Precision::float32) {
  std::vector<const Family*> wanted;
  for (const Family& one : families())
    if (one.topic == topic && (family.empty() || one.name == family)) wanted.push_back(&one);
  if (wanted.empty()) throw std::invalid_argument("there is no family \"" + topic + "/" + family + "\"");
  return rc::gen::mapcat(rc::gen::noShrink(rc::gen::elementOf(wanted)),
                         [precision](const Family* one) { return cases(*one, precision); });
}

/// The answer of a routine that gives the nearest t alone; infinity and NaN are misses.
[[nodiscard]] inline RayAnswer nearest_answer(double t) {
  RayAnswer answer{.nearest_only = true};
  if (std::isfinite(t)) answer.hits.push_back(t);
  return answer;
}

/// Whether the subject keeps the check's property of that name on the case; true, too, where the property
/// says nothing of the case. Throws std::invalid_argument where there is none of that name.
[[nodiscard]] inline bool keeps(const Subject& subject, const std::string& property, const Case& one) {
  const Property* named = find_property(property);
  if (named == nullptr) throw std::invalid_argument("there is no property \"" + property + "\"");
  Trial trial(subject, one);
  return named->rule(trial) != Ruling::broken;
}

/// Counts what the case is ("hit", "tangent", "from inside", …) for rapidcheck's distribution of cases.
inline void classify(const Case& one) {
  for (const std::string& label : labels_of(one)) RC_CLASSIFY(true, label);
}

}  // namespace rayproof
