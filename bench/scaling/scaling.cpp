#include "bench/scaling/scaling.hpp"

#include <fmt/format.h>

#include <iterator>

namespace rayproof::report {

std::vector<BenchRow> measure_scaling(const BenchOptions& options, const ProgressListener& listener) {
  std::vector<ScalingStep> steps;
  for (const auto& [name, made_by] :
       {std::pair{"scenes", scenes_scaling}, std::pair{"polygon_size", polygon_scaling},
        std::pair{"threads", threads_scaling}})
    if (options.wants_scaling(name)) std::ranges::move(made_by(options), std::back_inserter(steps));

  std::vector<BenchRow> rows;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const BenchRow& pattern = steps[i].pattern;
    listener(static_cast<double>(i) / static_cast<double>(steps.size()),
             fmt::format("{} {} {}", pattern.family, pattern.shape, pattern.size));
    std::ranges::move(steps[i].measure(pattern), std::back_inserter(rows));
  }
  return rows;
}

}  // namespace rayproof::report
