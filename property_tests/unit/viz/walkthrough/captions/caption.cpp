#include "unit/viz/walkthrough/captions/caption.hpp"

#include <algorithm>
#include <cmath>

#include "viz/explain/case_report.hpp"

namespace rayproof::viz {
namespace {

/// Its square is a normal double.
bool is_tame(double x) { return x > 1e-140 && x < 1e140; }

/// How much of a text a number or vector at its beginning may take at most.
std::size_t longest_number(std::string_view text) {
  std::size_t length = 0;
  while (length < text.size()) {
    const std::string_view rest = text.substr(length);
    const std::size_t word = rest.starts_with("∞") || rest.starts_with("NaN") ? 3 : 0;
    const bool is_digit = std::string_view("0123456789.-e+(), ").find(rest[0]) != std::string_view::npos;
    if (word == 0 && !is_digit) break;
    length += std::max<std::size_t>(word, 1);
  }
  return length;
}

}  // namespace

std::vector<CheckedClaim> kernel_claims() {
  std::vector<CheckedClaim> all;
  for (const auto group : {plane_claims, triangle_claims, sheared_triangle_claims, sphere_claims,
                           cylinder_claims, quadratic_claims, box_claims, parallelepiped_claims}) {
    const std::vector<CheckedClaim> more = group();
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

bool fits(std::string_view pattern, std::string_view sentence) {
  const std::size_t gap = pattern.find_first_of("#*");
  if (gap == std::string_view::npos) return pattern == sentence;
  if (!sentence.starts_with(pattern.substr(0, gap))) return false;
  const std::string_view rest = sentence.substr(gap);
  const std::size_t most = pattern[gap] == '*' ? rest.size() : longest_number(rest);
  for (std::size_t length = most; length > 0; --length)
    if (fits(pattern.substr(gap + 1), rest.substr(length))) return true;
  return false;
}

const CheckedClaim* find_claim(const std::vector<CheckedClaim>& claims, std::string_view sentence) {
  const auto found = std::find_if(claims.begin(), claims.end(),
                                  [&](const CheckedClaim& claim) { return fits(claim.words, sentence); });
  return found == claims.end() ? nullptr : &*found;
}

testing::AssertionResult are_perpendicular(const glm::dvec3& a, const glm::dvec3& b, double part) {
  const double size = glm::length(a) * glm::length(b);
  if (!is_tame(size) || std::abs(glm::dot(a, b)) <= part * size) return testing::AssertionSuccess();
  return testing::AssertionFailure() << glm::dot(a, b) / size << " is the cosine";
}

testing::AssertionResult are_equal(double a, double b, double scale) {
  const bool is_known = std::isfinite(a) && std::isfinite(b) && is_tame(std::abs(scale));
  if (!is_known || std::abs(a - b) <= 1e-13 * std::abs(scale)) return testing::AssertionSuccess();
  return testing::AssertionFailure() << a << " is not " << b;
}

testing::AssertionResult are_equal(const glm::dvec3& a, const glm::dvec3& b, double scale) {
  return are_equal(glm::length(a - b), 0, scale);
}

testing::AssertionResult is_quotient(double value, double above, double below) {
  return are_equal(value * below, above, std::abs(value * below) + std::abs(above));
}

glm::dvec3 edge_to(const NumbersByName& n, const char* vertex) { return n.input(vertex) - n.input("a"); }

void expect_hit(const CaseReport& report, double inside, double t) {
  const Ray<double>& ray = std::get<RayQuestion>(report.one.question).ray;
  const double beyond = std::max(ray.t_min - t, t - ray.t_max);  // of the interval, negative within
  constexpr double clearly = 1e-9;
  // t is a difference of ways as long as the origin's: near the surface that is what rounding leaves of it.
  const double ways = std::abs(t) + glm::length(ray.origin) / glm::length(ray.direction);
  const bool is_clear = std::isfinite(inside) && std::isfinite(t) && std::abs(inside) > clearly &&
                        std::abs(beyond) > clearly * ways;
  if (!is_clear) return;
  EXPECT_EQ(!values_of(&report.exact).empty(), inside > 0 && beyond < 0) << inside << " inside at t = " << t;
}

}  // namespace rayproof::viz
