#include "bench/contenders/contender.hpp"

#include <algorithm>
#include <ctime>
#include <utility>

#include "bench/contenders/problem_contenders.hpp"
#include "bench/contenders/ray_contenders.hpp"
#include "bench/figures/median.hpp"

namespace rayproof::report {

// In its own file, since its batches are of equations; all others come from the library's list.
std::vector<Contender> quadratic_contenders(const std::vector<Case>& cases, Precision precision,
                                            const std::vector<InstructionSet>& sets);

namespace {

double seconds_on(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double seconds_of(const Contender& contender, std::size_t count, double (*now)()) {
  const double start = now();
  contender.pass(count);
  return now() - start;
}

/// As many problems as take a few milliseconds; a first, smaller pass warms up and measures the speed.
std::size_t affordable(const Contender& contender, std::size_t rays, double longest_pass, double (*now)()) {
  const std::size_t sample = std::min(rays, std::max<std::size_t>(512, rays / 32));
  seconds_of(contender, sample, now);
  const double each = seconds_of(contender, sample, now) / static_cast<double>(sample);
  return std::min(rays, std::max(sample, static_cast<std::size_t>(longest_pass / each)));
}

}  // namespace

double thread_seconds() { return seconds_on(CLOCK_THREAD_CPUTIME_ID); }
double wall_seconds() { return seconds_on(CLOCK_MONOTONIC); }

std::vector<std::vector<double>> time_passes(const std::vector<Contender>& contenders, std::size_t rays,
                                             double seconds, double (*now)()) {
  constexpr std::size_t fewest_rounds = 5;
  const double longest_pass = std::min(4e-3, seconds / 20);
  std::vector<std::size_t> counts;
  for (const Contender& contender : contenders)
    counts.push_back(affordable(contender, rays, longest_pass, now));

  std::vector<std::vector<double>> passes(contenders.size());
  const double start = now();
  const auto is_time_left = [&] { return now() - start < seconds; };
  for (std::size_t round = 0; round < fewest_rounds || is_time_left(); ++round) {
    for (std::size_t i = 0; i < contenders.size(); ++i)
      passes[i].push_back(1e9 * seconds_of(contenders[i], counts[i], now) / static_cast<double>(counts[i]));
  }
  return passes;
}

std::vector<BenchRow> timed_rows(const std::vector<Contender>& contenders, const BenchRow& pattern,
                                 std::size_t rays, double seconds, double (*now)()) {
  const auto passes = time_passes(contenders, rays, seconds, now);
  std::vector<BenchRow> rows(contenders.size(), pattern);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].method = contenders[i].method;
    rows[i].arrangement = contenders[i].arrangement;
    rows[i].ns_per_ray = median(passes[i]);
    rows[i].passes_ns = passes[i];
  }
  return rows;
}

std::vector<Contender> contenders(const std::string& topic, const std::vector<Case>& cases,
                                  Precision precision, const std::vector<InstructionSet>& sets) {
  std::vector<Contender> all;
  Topics::for_each([&]<class Topic>(std::type_identity<Topic>) {
    if (topic != Topic::name) return;
    if constexpr (std::is_same_v<Topic, quadratic::Topic>)
      all = quadratic_contenders(cases, precision, sets);
    else if constexpr (is_batched<Topic>)
      all =
          ray_contenders<typename Topic::Methods>(static_cast<const Topic*>(nullptr), cases, precision, sets);
    else
      all = problem_contenders<Topic>(cases, precision);
  });
  return all;
}

}  // namespace rayproof::report
