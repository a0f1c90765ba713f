#include "properties/shrink/moves.hpp"

#include <array>
#include <cmath>

#include "case/json/number_text.hpp"
#include "case/shape_format.hpp"
#include "generators/random.hpp"
#include "properties/numbers.hpp"

namespace rayproof {

namespace {

/// Offers a copy of `best` changed by `change`.
template <class Change>
void attempt_changed(const Case& best, const Try& attempt, Change&& change) {
  Case candidate = best;
  change(candidate);
  attempt(candidate);
}

std::size_t count_numbers(Case one) { return numbers_of(one).size(); }

double& number(Case& one, std::size_t index) { return *numbers_of(one)[index].value; }

double number_in(Case one, std::size_t index) { return number(one, index); }

/// Leaves out the transform and the interval.
void drop_parts(const Case& best, const Try& attempt) {
  if (!std::holds_alternative<RayQuestion>(best.question)) return;
  attempt_changed(best, attempt, [](Case& one) { std::get<RayQuestion>(one.question).transform.reset(); });
  for (const double t_min : {0.0, -infinity<double>})
    attempt_changed(best, attempt, [&](Case& one) {
      auto& ray = std::get<RayQuestion>(one.question).ray;
      ray.t_min = t_min;
      ray.t_max = infinity<double>;
    });
}

/// Calls `act` with the list of vertices, if the case has one.
template <class Act>
void with_vertices(Case& one, Act&& act) {
  if (auto* place = std::get_if<PointAndPolygon<double>>(&one.question)) return act(place->vertices);
  auto* asked = std::get_if<RayQuestion>(&one.question);
  auto* polygon = asked == nullptr ? nullptr : std::get_if<Polygon<double>>(&asked->shape);
  if (polygon != nullptr) act(polygon->vertices);
}

std::size_t count_vertices(Case one) {
  std::size_t count = 0;
  with_vertices(one, [&](const auto& vertices) { count = vertices.size(); });
  return count;
}

/// Leaves out vertices of a polygon: half of them, then one by one.
void drop_vertices(const Case& best, const Try& attempt) {
  for (std::size_t run = count_vertices(best) / 2; run > 0; run /= 2)
    for (std::size_t i = 0; i + run <= count_vertices(best); ++i)
      attempt_changed(best, attempt, [&](Case& one) {
        with_vertices(one, [&](auto& vertices) {
          const auto from = vertices.begin() + static_cast<std::ptrdiff_t>(i);
          vertices.erase(from, from + static_cast<std::ptrdiff_t>(run));
        });
      });
}

/// Moves a point of the shape to the origin, the ray with it.
void move_to_origin(const Case& best, const Try& attempt) {
  if (!std::holds_alternative<RayQuestion>(best.question)) return;
  for (std::size_t field = 0; field < 3; ++field)
    attempt_changed(best, attempt, [&](Case& one) {
      auto& asked = std::get<RayQuestion>(one.question);
      std::size_t seen = 0;
      const auto visit = [&](const char*, auto& value) {
        if constexpr (std::is_same_v<std::remove_reference_t<decltype(value)>, glm::dvec3>) {
          if (seen++ != field) return;
          for (int axis = 0; axis < 3; ++axis)
            asked.ray.origin[axis] = round_to(one.precision, asked.ray.origin[axis] - value[axis]);
          value = glm::dvec3(0);
        }
      };
      std::visit([&]<class S>(S& shape) { ShapeFormat<S>::fields(shape, visit); }, asked.shape);
    });
}

/// Multiplies several numbers at once by one power of two or ten.
void rescale(const Case& best, const Try& attempt) {
  const std::size_t count = count_numbers(best);
  // Runs of neighbours: the direction, the sphere, origin and sphere, the equation.
  for (const double base : {2.0, 10.0})
    for (int k = 30; k > 0; k = k * 2 / 3)
      for (const double factor : {std::pow(base, k), std::pow(base, -k)})
        for (std::size_t skip = 0; skip <= count; skip += 3)
          attempt_changed(best, attempt, [&](Case& one) {
            const auto numbers = numbers_of(one);
            for (std::size_t i = 0; i < count; ++i)
              if (i < skip || i >= skip + 3)
                *numbers[i].value = round_to(one.precision, *numbers[i].value * factor);
          });
}

/// Puts the origin straight behind the shape, so far away as to make the case simple: a sphere that is far
/// enough is missed in plain numbers, too.
void look_straight(const Case& best, const Try& attempt) {
  if (!std::holds_alternative<RayQuestion>(best.question)) return;
  constexpr int tries_per_distance = 40;
  Random random(2);
  for (int digits = 1; digits <= 3; ++digits)
    for (int distance = 0; distance <= 12; ++distance)
      for (int k = 0; k < tries_per_distance; ++k)
        attempt_changed(best, attempt, [&](Case& one) {
          for (const CaseNumber& n : numbers_of(one))
            *n.value = to_digits(*n.value, digits, random.between(-2, 2), one.precision);
          auto& ray = std::get<RayQuestion>(one.question).ray;
          for (int axis = 0; axis < 3; ++axis)
            ray.origin[axis] = round_to(one.precision, -std::pow(10.0, distance) * ray.direction[axis]);
        });
}

/// Makes one number simpler.
void simplify_one(const Case& best, const Try& attempt) {
  for (std::size_t i = 0; i < count_numbers(best); ++i)
    for (const double simpler : simpler_numbers(number_in(best, i), best.precision))
      attempt_changed(best, attempt, [&](Case& one) { number(one, i) = simpler; });
}

/// Makes two numbers simpler at once, or equal.
void simplify_two(const Case& best, const Try& attempt) {
  for (std::size_t i = 0; i < count_numbers(best); ++i)
    for (std::size_t j = 0; j < count_numbers(best); ++j) {
      if (i == j) continue;
      attempt_changed(best, attempt, [&](Case& one) { number(one, i) = number(one, j); });
      const std::vector<double> for_j = simpler_numbers(number_in(best, j), best.precision);
      for (const double x : {0.0, 1.0, to_digits(number_in(best, i), 1, 0, best.precision),
                             to_digits(number_in(best, i), 2, 0, best.precision)})
        for (std::size_t k = 0; k < std::min<std::size_t>(for_j.size(), 16); ++k)
          attempt_changed(best, attempt, [&](Case& one) {
            number(one, i) = x;
            number(one, j) = for_j[k];
          });
    }
}

/// Rounds all numbers at once to few digits, each with a little luck: for cases in which every digit seems to
/// count.
void round_all(const Case& best, const Try& attempt) {
  constexpr int tries_per_digit = 1500;
  Random random(1);
  for (int digits = 1; digits <= 3; ++digits)
    for (int k = 0; k < tries_per_digit; ++k)
      attempt_changed(best, attempt, [&](Case& one) {
        for (const CaseNumber& n : numbers_of(one)) {
          const int choice = random.between(0, 9);
          if (choice == 0) *n.value = n.plain;
          if (choice == 1) *n.value = to_digits(*n.value, 1, 0, one.precision);
          if (choice >= 4) *n.value = to_digits(*n.value, digits, random.between(-3, 3), one.precision);
        }
      });
}

}  // namespace

std::span<const Move> moves() {
  static constexpr std::array all{drop_parts,   drop_vertices, move_to_origin, rescale,
                                  simplify_one, look_straight, simplify_two,   round_all};
  return all;
}

}  // namespace rayproof
