#include "bench/contenders/contender.hpp"

#include <algorithm>
#include <ctime>
#include <utility>

#include "bench/contenders/problem_contenders.hpp"
#include "bench/contenders/ray_contenders.hpp"

namespace rayproof::report {

// In its own file, since its batches are of equations; all others come from the library's list.
std::vector<Contender> quadratic_contenders(const std::vector<Case>& cases, Precision precision,
                                            const std::vector<InstructionSet>& sets);

namespace {

/// Seconds that this thread has run: the turns that other programs take on the processor don't count.
double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double seconds_of(const Contender& contender, std::size_t count) {
  const double start = thread_seconds();
  contender.pass(count);
  return thread_seconds() - start;
}

/// As many problems as take a few milliseconds; a first, smaller pass warms up and measures the speed.
std::size_t affordable(const Contender& contender, std::size_t rays) {
  constexpr double longest_pass = 4e-3;
  const std::size_t sample = std::min<std::size_t>(rays, 2048);
  seconds_of(contender, sample);
  const double each = seconds_of(contender, sample) / static_cast<double>(sample);
  return std::min(rays, std::max(sample, static_cast<std::size_t>(longest_pass / each)));
}

}  // namespace

std::vector<std::vector<double>> time_passes(const std::vector<Contender>& contenders, std::size_t rays,
                                             double seconds) {
  constexpr std::size_t fewest_rounds = 5;
  std::vector<std::size_t> counts;
  for (const Contender& contender : contenders) counts.push_back(affordable(contender, rays));

  std::vector<std::vector<double>> passes(contenders.size());
  const double start = thread_seconds();
  const auto is_time_left = [&] { return thread_seconds() - start < seconds; };
  for (std::size_t round = 0; round < fewest_rounds || is_time_left(); ++round) {
    for (std::size_t i = 0; i < contenders.size(); ++i)
      passes[i].push_back(1e9 * seconds_of(contenders[i], counts[i]) / static_cast<double>(counts[i]));
  }
  return passes;
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
