#include "properties/leaving/search.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <map>

#include "case/reader/near_names.hpp"
#include "case/writer.hpp"
#include "oracle/numbers/ulp.hpp"

namespace rayproof::leaving {

namespace {

/// Situations that one thread takes at a time; a search can be stopped between blocks of blocks.
constexpr std::uint64_t situations_at_a_time = 1024, situations_in_block = 1U << 17U;

using Tallies = std::vector<StrategyTally>;

std::uint64_t start_of(std::uint64_t seed, const std::string& shape, Precision precision) {
  std::uint64_t start = combine(seed, precision == Precision::float32 ? 32U : 64U);
  for (const char letter : shape) start = combine(start, static_cast<unsigned char>(letter));
  return start;
}

/// What one strategy made of one situation.
struct Started {
  double length;  ///< of its offset
  bool is_clear;
};

Started count(StrategyTally& tally, const Strategy& strategy, const Situation& situation,
              std::uint64_t number) {
  const glm::dvec3 origin = strategy.origin(situation);
  const glm::dvec3 offset = origin - (strategy.moves_to_surface ? situation.from.point : situation.from.hit);
  Count& counted = tally.by_size.at(decade_of(situation.extent.size));
  ++counted.rays;
  const double length = std::sqrt(dot(offset, offset));
  counted.offsets.add(length / situation.extent.size);
  const oracle::Departure departure = depart(strategy, situation, origin);
  const bool is_inward =
      situation.what.side == spawn::Side::back && oracle::has_inside(situation.question().shape);
  if (departure == oracle::Departure::clear && !is_inward) {
    const RayQuestion ray = next_ray(strategy, situation, origin);
    const Case one{.precision = situation.precision(), .question = ray};
    const Answer answer = plain_method_of(shape_name(ray.shape))->answer(one);
    counted.misanswered += std::get<RayAnswer>(answer).hits.count > 0;
  }
  if (departure == oracle::Departure::skipped) {
    ++counted.skipped;
    counted.thickest_skipped =
        std::max(counted.thickest_skipped, situation.extent.width / situation.extent.size);
  }
  const bool has_no_origin = departure == oracle::Departure::no_origin;
  counted.false_hits += departure == oracle::Departure::false_hit || has_no_origin;
  if (is_failure(strategy, departure)) tally.fail(number);
  return {length, departure == oracle::Departure::clear};
}

void count_all(Tallies& tallies, const std::vector<const Strategy*>& asked,
               const std::vector<Situation>& situations, std::uint64_t number) {
  const auto proven = std::ranges::find_if(asked, &Strategy::is_proven) - asked.begin();
  std::vector<Started> started(asked.size());
  for (std::size_t k = 0; k < situations.size(); ++k) {
    for (std::size_t i = 0; i < asked.size(); ++i)
      started[i] = count(tallies[i], *asked[i], situations[k], rays_from_a_hit * number + k);
    if (static_cast<std::size_t>(proven) == asked.size()) continue;
    for (std::size_t i = 0; i < asked.size(); ++i) {
      if (!started[i].is_clear) continue;
      Count& counted = tallies[i].by_size.at(decade_of(situations[k].extent.size));
      ++counted.compared;
      counted.tenfold += 10 * started[static_cast<std::size_t>(proven)].length <= started[i].length;
    }
  }
}

/// The situations from `begin` to `end` of a shape, left by each strategy.
Tallies run_block(const std::vector<const Strategy*>& asked, const std::vector<const Family*>& from,
                  Precision precision, std::uint64_t start, std::uint64_t begin, std::uint64_t end) {
  using Range = tbb::blocked_range<std::uint64_t>;
  const Tallies none(asked.size());
  return tbb::parallel_reduce(
      Range(begin, end, situations_at_a_time), none,
      [&](const Range& range, Tallies tallies) {
        for (std::uint64_t number = range.begin(); number != range.end(); ++number)
          count_all(tallies, asked, draw_situations(from, combine(start, number), precision), number);
        return tallies;
      },
      [](Tallies left, const Tallies& right) {
        for (std::size_t i = 0; i < left.size(); ++i) left[i] += right[i];
        return left;
      });
}

bool is_wanted(const std::vector<std::string>& wanted, const std::string& name) {
  return wanted.empty() || std::ranges::find(wanted, name) != wanted.end();
}

std::vector<const Strategy*> asked_of(const SearchSettings& settings) {
  std::vector<const Strategy*> asked;
  for (const Strategy& one : strategies())
    if (is_wanted(settings.strategies, one.name)) asked.push_back(&one);
  return asked;
}

std::vector<std::string> shapes_of(const SearchSettings& settings) {
  std::vector<std::string> shapes = topics_with_rays();
  std::erase_if(shapes, [&](const std::string& one) { return !is_wanted(settings.shapes, one); });
  return shapes;
}

SearchResult search_all(const SearchSettings& settings, const std::atomic<bool>& stop,
                        const std::function<void(double, const std::string&)>& progress) {
  const std::vector<const Strategy*> asked = asked_of(settings);
  const std::vector<std::string> shapes = shapes_of(settings);
  SearchResult result;
  const double all = static_cast<double>(shapes.size() * settings.precisions.size()) *
                     static_cast<double>(std::max<std::uint64_t>(settings.cases, 1));
  double done = 0;
  for (const std::string& shape : shapes)
    for (const Precision precision : settings.precisions) {
      const std::vector<const Family*> from = families_of(shape);
      const std::uint64_t start = start_of(settings.seed, shape, precision);
      Tallies tallies(asked.size());
      for (std::uint64_t begin = 0; begin < settings.cases && !stop; begin += situations_in_block) {
        const std::uint64_t end = std::min(settings.cases, begin + situations_in_block);
        const Tallies more = run_block(asked, from, precision, start, begin, end);
        for (std::size_t i = 0; i < asked.size(); ++i) tallies[i] += more[i];
        done += static_cast<double>(end - begin);
        progress(done / all, fmt::format("leaving {} {}", shape, name_of(precision)));
      }
      for (std::size_t i = 0; i < asked.size(); ++i)
        result.outcomes.push_back({asked[i], shape, precision, tallies[i]});
    }
  for (const Strategy* strategy : asked) {
    std::optional<WrongStart> best;
    std::size_t least = 0;
    for (const StrategyOutcome& outcome : result.outcomes) {
      if (outcome.strategy != strategy || !outcome.tally.first_failure) continue;
      const auto situation =
          situation_number(settings, outcome.shape, outcome.precision, *outcome.tally.first_failure);
      WrongStart failure = simplest(*strategy, situation, stop);
      const std::size_t size = write_case(failure.left).size();
      if (strategy->is_proven) result.failures.push_back(failure);
      if (strategy->is_proven || (best && size >= least)) continue;
      least = size;
      best = std::move(failure);
    }
    if (best) result.failures.push_back(std::move(*best));
  }
  result.was_interrupted = stop;
  return result;
}

}  // namespace

std::string unknown_names(const SearchSettings& settings) {
  std::vector<std::string> names;
  for (const Strategy& one : strategies()) names.push_back(one.name);
  const std::vector<std::string> shapes = topics_with_rays();
  for (const std::string& one : settings.strategies)
    if (std::ranges::find(names, one) == names.end())
      return fmt::format("there is no strategy \"{}\"{}", one, names_instead(one, names));
  for (const std::string& one : settings.shapes)
    if (std::ranges::find(shapes, one) == shapes.end())
      return fmt::format("there is no shape \"{}\"{}", one, names_instead(one, shapes));
  return "";
}

Situation situation_number(const SearchSettings& settings, const std::string& shape, Precision precision,
                           std::uint64_t number) {
  const std::uint64_t seed = combine(start_of(settings.seed, shape, precision), number / rays_from_a_hit);
  return draw_situations(families_of(shape), seed, precision).at(number % rays_from_a_hit);
}

SearchResult search(const SearchSettings& settings, const std::atomic<bool>& stop,
                    const std::function<void(double, const std::string&)>& progress) {
  const int jobs = settings.jobs > 0 ? settings.jobs : tbb::this_task_arena::max_concurrency();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(jobs));
  tbb::task_arena arena(jobs);
  return arena.execute([&] { return search_all(settings, stop, progress); });
}

}  // namespace rayproof::leaving
