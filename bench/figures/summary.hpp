#pragma once
/// \file
/// The figures over the families of scenes: what the plots and the first tables show.

#include <optional>

#include "bench/figures/row.hpp"

namespace rayproof::report {

/// One method in one precision and arrangement, over all its families.
struct MethodSummary {
  std::string shape;
  std::string method;
  Precision precision = Precision::float32;
  Arrangement arrangement = Arrangement::scalar;
  double ns_per_ray = 0;  ///< the median of the families
  Accuracy accuracy{};    ///< summed up; the worst ulps; mean bits over all agreed hits

  [[nodiscard]] bool is_floor() const { return method == floor_name; }
  [[nodiscard]] bool has_errors() const { return rayproof::report::has_errors(method); }
  /// The share of cases with a wrong verdict.
  [[nodiscard]] double wrong_share() const;
};

/// Whether a family's numbers are those of scenes. The others are drawn bit by bit or exponent by exponent;
/// there everything over- and underflows, which says little of a method.
[[nodiscard]] bool is_of_scenes(const std::string& family);

/// Over the families of scenes, in the order of the rows; over all families where only others were measured.
[[nodiscard]] std::vector<MethodSummary> summarise(const std::vector<BenchRow>& rows);

/// The headline of the docs: how the batch kernel of `sphere/centred` in float compares on the random
/// family.
struct Headline {
  double batch_ns = 0;
  double glm_ns = 0;
  double floor_ns = 0;
};

/// Empty where the rows that it needs were not measured.
[[nodiscard]] std::optional<Headline> headline(const std::vector<BenchRow>& rows);

/// The headline in one sentence.
[[nodiscard]] std::string sentence(const Headline& headline, std::size_t rays);

}  // namespace rayproof::report
