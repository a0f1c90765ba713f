/// \file
/// The random problems of every topic: our kernels one problem at a time and in batches, other people's
/// libraries, and the floor of streaming the rays. The time is that of one pass over all problems; items per
/// second are problems.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>

#include "bench/peers/peer.hpp"
#include "generators/generators.hpp"

namespace {

using namespace rayproof;

constexpr std::size_t problem_count = 65536;

std::vector<report::Contender> contenders_of(const Family& family, Precision precision, std::size_t count) {
  std::vector<Case> cases;
  for (std::uint64_t seed = 0; seed < count; ++seed) cases.push_back(family.generate(seed, precision));
  auto all = report::contenders(family.topic, cases, precision, available_instruction_sets());
  std::ranges::move(report::peer_contenders(family.topic, cases, precision), std::back_inserter(all));
  return all;
}

void add_all(const Family& family, Precision precision) {
  // The names are those of any number of problems. All are made when the first is timed.
  const std::vector<report::Contender> named = contenders_of(family, precision, 1);
  const auto timed = std::make_shared<std::vector<report::Contender>>();
  for (std::size_t i = 0; i < named.size(); ++i) {
    const bool is_scalar = named[i].arrangement == report::Arrangement::scalar;
    const std::string arrangement(is_scalar ? "scalar" : name_of(named[i].set));
    const std::string name = family.topic + "/" + named[i].method + "/" + arrangement +
                             (precision == Precision::float32 ? "/float" : "/double");
    benchmark::RegisterBenchmark(name.c_str(), [=, &family](benchmark::State& state) {
      if (timed->empty()) *timed = contenders_of(family, precision, problem_count);
      for (auto _ : state) (*timed)[i].pass(problem_count);
      state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(problem_count));
    })->Unit(benchmark::kMicrosecond);
  }
}

[[maybe_unused]] const bool shapes_are_registered = [] {
  for (const Family& family : families())
    if (family.name == "random")
      for (const Precision precision : {Precision::float32, Precision::float64}) add_all(family, precision);
  return true;
}();

}  // namespace
