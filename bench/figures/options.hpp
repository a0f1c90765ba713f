#pragma once
/// \file
/// What rayproof report is asked to measure.

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "generators/generators.hpp"
#include "subjects/subject.hpp"

namespace rayproof::report {

/// A name on the command line that nothing has; the text says so and which names there are.
class UnknownFilterName : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What is to be measured. An empty filter lets everything through.
struct BenchOptions {
  std::string json{};
  std::string figures{};   ///< a report's JSON to be shown in place of measuring
  std::string baseline{};  ///< one to compare with
  bool is_quick = false;
  std::string out = "out/report";
  std::size_t rays = 65536;
  std::size_t judged = 32768;  ///< the first of them: exact answers take longer than everything that is timed
  double seconds = 0.25;
  std::vector<std::string> families{}, methods{}, shapes{}, precisions{}, scaling{};

  [[nodiscard]] bool wants_shape(const std::string& shape) const;
  [[nodiscard]] bool wants_family(const Family& family) const;
  [[nodiscard]] bool wants_method(const std::string& shape, const std::string& method) const;
  [[nodiscard]] std::vector<Precision> wanted_precisions() const;
  /// The curves named; without names and filters, all.
  [[nodiscard]] bool wants_scaling(const std::string& curve) const;
  /// Whether methods are measured on their shapes: not where curves alone are asked for.
  [[nodiscard]] bool wants_rows() const { return scaling.empty(); }
  [[nodiscard]] bool has_filter() const { return !(shapes.empty() && methods.empty() && families.empty()); }
};

/// The curves that there are.
inline constexpr std::array scaling_names{"scenes", "polygon_size", "threads"};

/// Throws UnknownFilterName where a filter names nothing, or filters leave nothing to measure.
void validate(const BenchOptions& options);

}  // namespace rayproof::report
