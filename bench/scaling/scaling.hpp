#pragma once
/// \file
/// How times grow: with the objects of a scene, with the vertices of a polygon, with threads.

#include "bench/measuring/measure.hpp"

namespace rayproof::report {

/// A part of a curve: what is timed side by side at one size.
struct ScalingStep {
  BenchRow pattern{};  ///< what all its rows share
  std::function<std::vector<BenchRow>(const BenchRow& pattern)> measure{};
};

/// The nearest hit among 1 to 10⁶ objects (10⁵ of a quick report), in float: by a list, by trees over it, and
/// by Embree alone where it was built in.
[[nodiscard]] std::vector<ScalingStep> scenes_scaling(const BenchOptions& options);
/// Polygons of 3 to 1000 vertices in float, each ray or point with one of its own.
[[nodiscard]] std::vector<ScalingStep> polygon_scaling(const BenchOptions& options);
/// One batch of rays, or the rays through a scene, shared out to 1, 2, 4 … threads, up to the processor's.
[[nodiscard]] std::vector<ScalingStep> threads_scaling(const BenchOptions& options);

/// The curves that the options ask for; once `stop` is set, what was measured until then.
[[nodiscard]] std::vector<BenchRow> measure_scaling(const BenchOptions& options,
                                                    const std::atomic<bool>& stop,
                                                    const ProgressListener& listener);

}  // namespace rayproof::report
