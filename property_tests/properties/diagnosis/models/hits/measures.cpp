#include "properties/diagnosis/models/hits/measures.hpp"

#include <algorithm>
#include <cmath>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/examination/sizes_of_mistakes.hpp"
#include "properties/edges.hpp"

namespace rayproof::diagnosis {
namespace {

using Size = std::optional<double>;

/// A size, of which rounding makes up that much: it is measured where it is many times that. Below it there
/// is no mistake, if one were to be seen.
Size beyond(double size, double rounding) {
  constexpr double seen = 1e-8, clearly = 16;
  if (!std::isfinite(size)) return std::nullopt;
  if (std::abs(size) > clearly * rounding) return size;
  return std::abs(size) <= rounding && rounding < seen ? Size(0) : std::nullopt;
}

/// What several numbers show; 0 where they do not show the same.
Size all_alike(const std::vector<Size>& sizes) {
  if (sizes.empty() || std::ranges::any_of(sizes, [](const Size& one) { return !one; })) return std::nullopt;
  const std::size_t number = number_of_size(*sizes.front());
  const bool are_alike = std::ranges::all_of(
      sizes, [&](const Size& one) { return (*one == 0 && *sizes.front() == 0) || is_of_size(*one, number); });
  return are_alike ? sizes.front() : Size(0);
}

/// What the rounding of the scene's lengths does to t; nothing to a root.
double rounding_of_t(const Case& one) {
  const RayQuestion* asked = ray_question(one);
  return asked == nullptr
             ? 0
             : share_of_rounding(one.precision) * size_of_scene(one) / glm::length(asked->ray.direction);
}

Size factor_between(const Case& one, double got, double exact) {
  if (exact == 0 || !std::isfinite(exact)) return std::nullopt;
  return beyond(got / exact - 1, share_of_rounding(one.precision) + rounding_of_t(one) / std::abs(exact));
}

/// Whether t is the first, or the second, of two hits of the line.
bool is_of_root(const Case& one, double t, bool is_first) {
  if (ray_question(one) == nullptr) return false;
  const HitList line = hits_of_line(one).hits;
  return line.count == 2 && t == line.t[is_first ? 0 : 1];
}

/// Whether the one of two roots is so small beside the other that -b ± √D loses most of its digits, or all:
/// what it is then is no factor.
bool loses_smaller_root(const Case& one, const std::vector<double>& roots) {
  if (ray_question(one) != nullptr || roots.size() < 2) return false;
  const double small = std::min(std::abs(roots[0]), std::abs(roots[1]));
  const double large = std::max(std::abs(roots[0]), std::abs(roots[1]));
  return small < (one.precision == Precision::float32 ? 0x1p-16 : 0x1p-40) * large;
}

/// The hits on a sphere, seen from its centre; none where the answer gives no t.
std::vector<glm::dvec3> hits_about_centre(const Case& one, const Answer& got) {
  std::vector<glm::dvec3> all;
  const auto* sphere = shape_in<Sphere<double>>(one);
  const auto* ray = std::get_if<RayAnswer>(&got);
  if (sphere == nullptr || ray->verdict_only) return all;
  const Ray<double> own = ray_in_object(*ray_question(one));
  for (const double t : ray->hits.view()) all.push_back(point_at(own, t) - sphere->center);
  return all;
}

Answers with_radius(const Case& one, double factor, double more) {
  Case in_doubles = one;  // so little may be lost in float
  in_doubles.precision = Precision::float64;
  return exact_of(with_shape<Sphere<double>>(in_doubles, [&](const RayQuestion& /*asked*/, auto& sphere) {
    sphere.radius = factor * sphere.radius + more;
    return sphere.radius > 0;
  }));
}

}  // namespace

Size factor_of(const Case& one, const Answer& got, const Answer& exact, Bears which) {
  const std::vector<double> mine = numbers_in(got);
  std::vector<double> right = numbers_in(exact);
  if (mine.empty() || right.empty()) return std::nullopt;
  if (which == Bears::second && mine.size() == 2 && right.size() == 1) right.push_back(right.front());
  if (mine.size() > right.size() || loses_smaller_root(one, right)) return std::nullopt;
  std::vector<Size> sizes;
  for (std::size_t i = 0; i < mine.size(); ++i) sizes.push_back(factor_between(one, mine[i], right[i]));
  if (which == Bears::both) return all_alike(sizes);
  const bool is_first = which == Bears::first;
  if (sizes.size() < 2) return is_of_root(one, right.front(), is_first) ? sizes.front() : std::nullopt;
  const Size &wrong = sizes[is_first ? 0 : 1], &other = sizes[is_first ? 1 : 0];
  return other.value_or(0) == 0 ? wrong : Size(0);
}

Size added_to_numbers(const Case& one, const Answer& got, const Answer& exact) {
  const std::vector<double> mine = numbers_in(got), right = numbers_in(exact);
  if (mine.size() > right.size()) return std::nullopt;
  std::vector<Size> sizes;
  for (std::size_t i = 0; i < mine.size(); ++i)
    sizes.push_back(beyond(mine[i] - right[i],
                           share_of_rounding(one.precision) * std::abs(right[i]) + rounding_of_t(one)));
  return all_alike(sizes);
}

Size added_in_lengths(const Case& one, const Answer& got, const Answer& exact) {
  const RayQuestion* asked = ray_question(one);
  const Size added = asked == nullptr ? std::nullopt : added_to_numbers(one, got, exact);
  return added ? Size(*added * glm::length(asked->ray.direction)) : std::nullopt;
}

Size factor_of_radius(const Case& one, const Answer& got, const Answer& /*exact*/) {
  std::vector<Size> sizes;
  for (const glm::dvec3& hit : hits_about_centre(one, got)) {
    const double radius = shape_in<Sphere<double>>(one)->radius;
    sizes.push_back(beyond(glm::length(hit) / radius - 1,
                           share_of_rounding(one.precision) * (1 + size_of_scene(one) / radius)));
  }
  return all_alike(sizes);
}

Size added_to_radius(const Case& one, const Answer& got, const Answer& /*exact*/) {
  std::vector<Size> sizes;
  for (const glm::dvec3& hit : hits_about_centre(one, got))
    sizes.push_back(beyond(glm::length(hit) - shape_in<Sphere<double>>(one)->radius,
                           share_of_rounding(one.precision) * size_of_scene(one)));
  return all_alike(sizes);
}

Answers with_radius_times(const Case& one, const Answer& /*exact*/, double more) {
  return with_radius(one, 1 + more, 0);
}

Answers with_radius_plus(const Case& one, const Answer& /*exact*/, double more) {
  return with_radius(one, 1, more);
}

}  // namespace rayproof::diagnosis
