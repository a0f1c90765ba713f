#include "leaks/search.hpp"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "generators/random.hpp"
#include "leaks/judge.hpp"

namespace rayproof::leaks {

namespace {

constexpr std::uint64_t rays_at_a_time = 64, rays_in_block = 1U << 14U;

using All = std::vector<Outcomes>;
using Answerers = std::vector<std::unique_ptr<Answerer>>;

/// Asks each subject all cases of some crossings at once.
void ask(All& all, Answerers& answerers, const std::vector<PatchCrossing>& crossings) {
  std::vector<Case> cases;
  for (const PatchCrossing& one : crossings) cases.insert(cases.end(), one.cases.begin(), one.cases.end());
  for (std::size_t s = 0; s < all.size(); ++s) {
    std::vector<Outcome> outcomes(cases.size());
    answerers[s]->answer(cases, outcomes);
    std::size_t begin = 0;
    for (const PatchCrossing& one : crossings) {
      judge(all[s], one, std::span(outcomes).subspan(begin, one.cases.size()));
      begin += one.cases.size();
    }
  }
}

All none_of(const std::vector<const Subject*>& subjects, Precision precision) {
  All none;
  for (const Subject* subject : subjects) none.push_back({.subject = subject, .precision = precision});
  return none;
}

All run_block(const Targets& targets, const All& none, tbb::enumerable_thread_specific<Answerers>& answerers,
              std::uint64_t seed, std::uint64_t begin, std::uint64_t end, const std::atomic<bool>& stop) {
  using Range = tbb::blocked_range<std::uint64_t>;
  const auto run = [&](const Range& range, All all) {
    if (stop) return all;
    std::vector<PatchCrossing> crossings;
    for (std::uint64_t number = range.begin(); number != range.end(); ++number)
      if (auto one = crossing_of(targets, number, seed, none.front().precision))
        crossings.push_back(std::move(*one));
    ask(all, answerers.local(), crossings);
    return all;
  };
  return tbb::parallel_reduce(Range(begin, end, rays_at_a_time), none, run, [](All left, const All& right) {
    for (std::size_t i = 0; i < left.size(); ++i) left[i] += right[i];
    return left;
  });
}

Result search_all(const ClosedMesh& mesh, const std::vector<const Subject*>& subjects,
                  const LeakSettings& settings, const std::atomic<bool>& stop,
                  const std::function<void(double, const std::string&)>& progress) {
  tbb::enumerable_thread_specific<Answerers> answerers([&] {
    Answerers all;
    for (const Subject* subject : subjects) all.push_back(subject->start());
    return all;
  });
  Result result;
  const double all = static_cast<double>(settings.rays * settings.precisions.size());
  double done = 0;
  for (const Precision precision : settings.precisions) {
    const ClosedMesh own = rounded(mesh, precision);
    const Targets targets = targets_of(own);
    const std::uint64_t seed = combine(settings.seed, precision == Precision::float32 ? 32U : 64U);
    const All none = none_of(subjects, precision);
    All outcomes = none;
    for (std::uint64_t begin = 0; begin < settings.rays && !stop; begin += rays_in_block) {
      const std::uint64_t end = std::min(settings.rays, begin + rays_in_block);
      const All more = run_block(targets, none, answerers, seed, begin, end, stop);
      for (std::size_t i = 0; i < outcomes.size(); ++i) outcomes[i] += more[i];
      done += static_cast<double>(end - begin);
      progress(done / all, fmt::format("{} {}", mesh.name, name_of(precision)));
    }
    result.outcomes.insert(result.outcomes.end(), outcomes.begin(), outcomes.end());
  }
  result.was_interrupted = stop;
  return result;
}

}  // namespace

bool is_held_to(const Subject& subject) {
  return !subject.has_own_contract || subject.contract.standing == Standing::sound;
}

Result search(const ClosedMesh& mesh, const std::vector<const Subject*>& subjects,
              const LeakSettings& settings, const std::atomic<bool>& stop,
              const std::function<void(double, const std::string&)>& progress) {
  const int jobs = settings.jobs > 0 ? settings.jobs : tbb::this_task_arena::max_concurrency();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(jobs));
  tbb::task_arena arena(jobs);
  return arena.execute([&] { return search_all(mesh, subjects, settings, stop, progress); });
}

}  // namespace rayproof::leaks
