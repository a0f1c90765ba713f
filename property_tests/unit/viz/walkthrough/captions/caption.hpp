#pragma once
/// \file
/// Every sentence of a caption, and what tests hold it to: a check against the exact numbers, or the explicit
/// entry that it claims nothing about the case.

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <string_view>
#include <vector>

#include "viz/explain/case_report.hpp"
#include "viz/scene/items.hpp"

namespace rayproof::viz {

/// What a sentence was said of: the exact numbers known in a step (rounded to double) and the rounded ones.
struct Said {
  const CaseReport& report;
  const NumbersByName& n;
};

/// A sentence with "#" in the place of each number or vector and "*" in that of any text, and its check; no
/// check for a sentence that is true of every case by its words alone.
struct CheckedClaim {
  const char* words;
  void (*check)(const Said& said) = nullptr;
};

/// Sentences of kernels, by topic.
[[nodiscard]] std::vector<CheckedClaim> plane_claims();
[[nodiscard]] std::vector<CheckedClaim> triangle_claims();
[[nodiscard]] std::vector<CheckedClaim> sheared_triangle_claims();
[[nodiscard]] std::vector<CheckedClaim> sphere_claims();
[[nodiscard]] std::vector<CheckedClaim> cylinder_claims();
[[nodiscard]] std::vector<CheckedClaim> quadratic_claims();
[[nodiscard]] std::vector<CheckedClaim> box_claims();
[[nodiscard]] std::vector<CheckedClaim> parallelepiped_claims();

/// All of these.
[[nodiscard]] std::vector<CheckedClaim> kernel_claims();

/// The claim that a sentence makes; null for a sentence that nobody has entered.
[[nodiscard]] const CheckedClaim* find_claim(const std::vector<CheckedClaim>& claims,
                                             std::string_view sentence);

/// Whether a sentence is of a pattern as of CheckedClaim's.
[[nodiscard]] bool fits(std::string_view pattern, std::string_view sentence);

/// `part` of both lengths: the exact numbers are rounded to double before a test sees them. What is not
/// finite, or whose squares leave the range of double, passes.
[[nodiscard]] testing::AssertionResult are_perpendicular(const glm::dvec3& a, const glm::dvec3& b,
                                                         double part = 1e-14);

/// Up to a part of 1e-13 of the scale, as above.
[[nodiscard]] testing::AssertionResult are_equal(double a, double b, double scale);
[[nodiscard]] testing::AssertionResult are_equal(const glm::dvec3& a, const glm::dvec3& b, double scale);

/// The number of a name is a quotient of the two.
[[nodiscard]] testing::AssertionResult is_quotient(double value, double above, double below);

/// From the first vertex of a triangle to another.
[[nodiscard]] glm::dvec3 edge_to(const NumbersByName& n, const char* vertex);

/// The claim holds of the exact answer: a ray that meets the shape's whole surface at t hits it exactly where
/// the numbers say so. `inside` is positive within, negative beyond, and near 0 says nothing.
void expect_hit(const CaseReport& report, double inside, double t);

}  // namespace rayproof::viz
