#pragma once
/// \file
/// The figures of the report, with the meaning and the names they have in the case format.

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace rayproof::report {

enum class Arrangement { scalar, batch };

[[nodiscard]] constexpr const char* name_of(Arrangement arrangement) {
  return arrangement == Arrangement::scalar ? "scalar" : "batch";
}

inline constexpr const char* floor_name = "streaming";
inline constexpr const char* oracle_name = "oracle";

/// Other people's libraries, where they were built in.
inline constexpr std::array peer_names{"glm", "vtk", "embree", "cgal"};
[[nodiscard]] inline bool is_peer(const std::string& method) {
  return std::ranges::find(peer_names, method) != peer_names.end();
}

/// Whether what is timed by this name answers cases, so that its errors can be counted.
[[nodiscard]] inline bool has_errors(const std::string& method) {
  return method != floor_name && method != oracle_name;
}

/// How wrong a method's answers to a family of cases are. Wrong verdicts are counted apart, never averaged
/// in.
struct Accuracy {
  std::size_t cases = 0;
  std::size_t wrong_hits = 0;    ///< cases with a hit (or root) too many
  std::size_t wrong_misses = 0;  ///< cases with a hit (or root) too few
  /// The rest is over the hits that method and oracle agree on; NaN where there are none.
  std::size_t agreed_hits = 0;
  double max_ulp = 0;
  double p99_ulp = 0;
  /// Herbie's measure: the mean of log2(1 + floats between the hit and the correctly rounded one).
  double mean_bits = 0;
  /// The worst errors of the first hit's point, normal and coordinates in contract units
  /// (method/contract.hpp, HitBounds), over every eighth case; NaN where there are none.
  double max_point = 0;
  double max_normal = 0;
  double max_coordinates = 0;
};

/// One method on one family, in one precision and arrangement. The floor has the method name `streaming` and
/// no errors; neither has `oracle`, the exact judge of them all, nor what is timed for a curve.
struct BenchRow {
  std::string shape{};
  std::string method{};
  Precision precision = Precision::float32;
  Arrangement arrangement = Arrangement::scalar;
  std::string family{};
  double ns_per_ray = 0;  ///< the median of the passes
  Accuracy accuracy{};
  std::vector<double> passes_ns{};  ///< nanoseconds a ray of each timed pass
  std::size_t size = 0;             ///< of a curve: how many objects, vertices or threads; else 0

  [[nodiscard]] bool is_floor() const { return method == floor_name; }
  [[nodiscard]] bool has_errors() const { return rayproof::report::has_errors(method) && size == 0; }
  /// Whether both are of one method on one family, in one precision, arrangement and size.
  [[nodiscard]] bool is_same_as(const BenchRow& other) const {
    return shape == other.shape && method == other.method && precision == other.precision &&
           arrangement == other.arrangement && family == other.family && size == other.size;
  }
};

/// Everything the report knows.
struct Measurements {
  std::string machine;
  std::string compiler;
  std::size_t rays = 0;  ///< how many rays one timed pass takes
  std::vector<BenchRow> rows;
  std::vector<BenchRow> scaling{};  ///< the curves: the family is the curve's name
};

}  // namespace rayproof::report
