#pragma once
/// \file
/// Cases of every shape to try the oracle on: all that the generators' families aim at, and scenes of small
/// whole numbers.

#include <string>

#include "generators/generators.hpp"
#include "unit/oracle/cases.hpp"
#include "unit/shape_types.hpp"

namespace rayproof::oracle::test {

/// A ray and one of the topic's shapes, of whole numbers so small that they meet in corners and on edges;
/// lines half the time.
[[nodiscard]] inline Case whole_case(const std::string& topic, std::uint64_t seed, Precision precision) {
  Random random(seed);
  const int size = random.between(1, 6);
  RayQuestion question =
      question_of_topic(topic, random, [&] { return double{1} * random.between(-size, size); });
  if (random.one_in(2)) {
    question.ray.t_min = -infinity<double>;
    question.ray.t_max = infinity<double>;
  }
  return {.precision = precision, .question = question};
}

/// Calls `check(case)`, in both precisions, for `per_family` cases of every family of the topic and ten times
/// as many of small whole numbers. Stops at the first that fails.
template <class Check>
void for_each_case(const std::string& topic, std::uint64_t per_family, Check&& check) {
  const auto try_all = [&](const std::string& name, std::uint64_t count, const auto& make) {
    for (std::uint64_t seed = 0; seed < count && !testing::Test::HasFailure(); ++seed) {
      for (const Precision precision : {Precision::float32, Precision::float64}) {
        SCOPED_TRACE(topic + " " + name + " " + std::to_string(seed) +
                     (precision == Precision::float32 ? " in float" : " in double"));
        check(make(seed, precision));
      }
    }
  };
  for (const Family& family : families())
    if (family.topic == topic)
      try_all(family.name, per_family,
              [&](std::uint64_t seed, Precision precision) { return family.generate(seed, precision); });
  if (topic == "quadratic" || topic == "point_in_polygon") return;
  try_all("of whole numbers", 10 * per_family,
          [&](std::uint64_t seed, Precision precision) { return whole_case(topic, seed, precision); });
}

/// Tests that are run for each topic, by its name.
class EveryShape : public testing::TestWithParam<std::string> {};

[[nodiscard]] inline std::string topic_name(const testing::TestParamInfo<std::string>& info) {
  return info.param;
}

}  // namespace rayproof::oracle::test
