#pragma once
/// \file
/// The laboratory's cases for properties in rapidcheck's own style: generators that shrink to the case a
/// person reads most easily, and show it as one line of JSON.
///
///     RC_GTEST_PROP(MySphere, AgreesWithTheOracle, ()) {
///       const Case one = *cases("sphere");
///       RC_ASSERT(!oracle::judge(one, my_answer(one)).wrong);
///     }

#include <rapidcheck.h>

#include <algorithm>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "case/writer.hpp"
#include "generators/generators.hpp"
#include "oracle/oracle.hpp"
#include "properties/labels.hpp"
#include "properties/shrink/moves.hpp"
#include "properties/shrink/simplicity.hpp"
#include "properties/shrink/validity.hpp"

namespace rayproof {

/// How rapidcheck shows a case: as the line that every program of the laboratory reads.
inline void showValue(const Case& one, std::ostream& out) { out << write_case(one); }

/// The valid cases that are one step simpler, the boldest step first; a proper figure stays one.
[[nodiscard]] inline std::vector<Case> simpler_cases(const Case& one) {
  std::vector<Case> simpler;
  const unsigned limit = complexity(one);
  const bool stays_proper = is_proper(one);
  const auto keep = [&](const Case& candidate) {
    if (complexity(candidate) < limit && is_valid(candidate) && (!stays_proper || is_proper(candidate)))
      simpler.push_back(candidate);
    return false;
  };
  for (const auto move : shrink_moves::all) move(one, keep);
  return simpler;
}

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

/// Counts what the case is ("hit", "tangent", "from inside", …) for rapidcheck's distribution of cases.
inline void classify(const Case& one) {
  for (const std::string& label : labels_of(one)) RC_CLASSIFY(true, label);
}

}  // namespace rayproof
