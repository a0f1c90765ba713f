/// \file
/// What the oracle costs: one exact verdict with the exact error of the nearest hit (or of each root), on
/// random and on tangent input. Items per second are judgements.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "generators/generators.hpp"
#include "oracle/oracle.hpp"
#include "subjects/subject.hpp"

namespace {

using namespace rayproof;

/// Cases with the answers that are to be judged.
struct Trials {
  std::vector<Case> cases;
  std::vector<Answer> answers;
};

bool is_tangent(const Case& one) {
  const auto answer = oracle::answer(one);
  const auto* ray = std::get_if<RayAnswer>(&answer);
  return ray != nullptr && ray->contact == Contact::tangent;
}

/// The method's answer; of a ray's hits the nearest only, which is what a renderer asks for.
Answer claim(const char* method, const Case& one) {
  Answer answer = find_subject(method)->answer(one);
  if (auto* ray = std::get_if<RayAnswer>(&answer)) {
    ray->nearest_only = true;
    ray->hits.count = std::min<std::size_t>(ray->hits.count, 1);
  }
  return answer;
}

/// The first `count` cases of a family that are `wanted`, answered by a method.
template <class Wanted>
Trials trials(const std::string& topic, const std::string& name, Precision precision, const char* method,
              const Wanted& wanted) {
  constexpr std::size_t count = 1024;  // few enough to lie in the caches, too many for branch prediction
  Trials made;
  for (const Family& family : families()) {
    if (family.topic != topic || family.name != name) continue;
    for (std::uint64_t seed = 0; made.cases.size() < count && seed < 100 * count; ++seed) {
      Case one = family.generate(seed, precision);
      if (!wanted(one)) continue;
      made.answers.push_back(claim(method, one));
      made.cases.push_back(std::move(one));
    }
  }
  return made;
}

void judge(benchmark::State& state, const Trials& trials) {
  if (trials.cases.empty()) return state.SkipWithError("the family has no such cases");
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(oracle::judge(trials.cases[i], trials.answers[i]));
    i = i + 1 == trials.cases.size() ? 0 : i + 1;
  }
  state.SetItemsProcessed(state.iterations());
}

template <class Wanted>
void add(const char* name, const char* topic, const char* family, const char* method, const Wanted& wanted) {
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    const std::string full =
        std::string("judge/") + name + (precision == Precision::float32 ? "/float" : "/double");
    benchmark::RegisterBenchmark(
        full.c_str(),
        [=](benchmark::State& state) { judge(state, trials(topic, family, precision, method, wanted)); })
        ->Repetitions(9)
        ->DisplayAggregatesOnly();
  }
}

[[maybe_unused]] const bool oracle_is_registered = [] {
  const auto all = [](const Case&) { return true; };
  add("sphere/random", "sphere", "random", "sphere/centred", all);
  add("sphere/tangent", "sphere", "grazing", "sphere/centred", is_tangent);
  add("sphere/grazing", "sphere", "grazing", "sphere/centred", all);
  add("sphere/transformed", "sphere", "transformed", "sphere/centred", all);
  for (const auto& [topic, method] :
       std::vector<std::pair<const char*, const char*>>{{"plane", "plane/implicit"},
                                                        {"triangle", "triangle/moller_trumbore"},
                                                        {"polygon", "polygon/winding"},
                                                        {"box", "box/slabs"},
                                                        {"parallelepiped", "parallelepiped/face_planes"},
                                                        {"cylinder", "cylinder/centred"}}) {
    add((std::string(topic) + "/random").c_str(), topic, "random", method, all);
    add((std::string(topic) + "/transformed").c_str(), topic, "transformed", method, all);
  }
  add("point_in_polygon/random", "point_in_polygon", "random", "point_in_polygon/winding", all);
  add("quadratic/random", "quadratic", "random", "quadratic/kahan", all);
  add("quadratic/near_double", "quadratic", "near_double", "quadratic/kahan", all);
  return true;
}();

}  // namespace
