#include "bench/scaling/scaling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace rayproof::report {

std::vector<BenchRow> measure_scaling(const BenchOptions& options, const std::atomic<bool>& stop,
                                      const ProgressListener& listener) {
  std::vector<ScalingStep> steps;
  const auto add = [&](const char* name, std::vector<ScalingStep> (*curve)(const BenchOptions&)) {
    if (options.wants_scaling(name)) std::ranges::move(curve(options), std::back_inserter(steps));
  };
  add("scenes", scenes_scaling);
  add("polygon_size", polygon_scaling);
  add("threads", threads_scaling);

  std::vector<BenchRow> rows;
  for (std::size_t i = 0; i < steps.size() && !stop; ++i) {
    const BenchRow& pattern = steps[i].pattern;
    listener(static_cast<double>(i) / static_cast<double>(steps.size()),
             fmt::format("{} {} {}", pattern.family, pattern.shape, pattern.size));
    std::ranges::move(steps[i].measure(pattern), std::back_inserter(rows));
  }
  return rows;
}

}  // namespace rayproof::report
