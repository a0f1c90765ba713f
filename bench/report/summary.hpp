#pragma once
/// \file
/// The figures over all families: what the plots and the first tables show.

#include <optional>

#include "bench/report/row.hpp"

namespace rayproof::report {

/// One method in one precision and arrangement, over all its families.
struct Summary {
  std::string shape;
  std::string method;
  Precision precision = Precision::float32;
  Arrangement arrangement = Arrangement::scalar;
  double ns_per_ray = 0;  ///< the median of the families
  Accuracy accuracy{};    ///< summed up; the worst ulps; mean bits over all agreed hits

  [[nodiscard]] bool is_floor() const { return method == Row::floor_name; }
  /// The share of cases with a wrong verdict.
  [[nodiscard]] double wrong_share() const;
};

/// In the order of the rows.
[[nodiscard]] std::vector<Summary> summarise(const std::vector<Row>& rows);

/// The headline of issue and docs: how the batch kernel of `sphere/centred` in float compares on the random
/// family.
struct Headline {
  double batch_ns = 0;
  double glm_ns = 0;
  double floor_ns = 0;
};

/// Empty where the rows that it needs were not measured.
[[nodiscard]] std::optional<Headline> headline(const std::vector<Row>& rows);

/// The headline in one sentence.
[[nodiscard]] std::string sentence(const Headline& headline, std::size_t rays);

}  // namespace rayproof::report
