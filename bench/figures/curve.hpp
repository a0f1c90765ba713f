#pragma once
/// \file
/// The rows of a curve, put in order: charts with lines of points.

#include <string>
#include <vector>

#include "bench/figures/row.hpp"

namespace rayproof::report {

/// One method at one size.
struct CurvePoint {
  std::size_t size = 1;
  double ns = 0;
  double low = 0, high = 0;  ///< quartiles of the passes
};

struct CurveLine {
  std::string name;
  std::vector<CurvePoint> points{};  ///< ascending in size
};

/// What stands in one pair of axes.
struct CurveChart {
  std::string title;
  std::vector<CurveLine> lines{};
};

/// What the report says of a curve.
struct CurveWords {
  const char* title;
  const char* sizes;  ///< what is counted: "objects"
  const char* note;
};
[[nodiscard]] CurveWords words_on(const std::string& curve);

/// The charts of one curve: one for each shape, of scenes one for plain and one for exact methods, each with
/// Embree alone, where it was measured.
[[nodiscard]] std::vector<CurveChart> charts_of(const std::vector<BenchRow>& rows, const std::string& curve);

/// A sentence where scenes were timed without Embree; else empty.
[[nodiscard]] std::string lack_of(const std::vector<CurveChart>& charts, const std::string& curve);

}  // namespace rayproof::report
