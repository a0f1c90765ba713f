#include "properties/shrink/moves.hpp"

#include <cmath>

#include "case/json/number_text.hpp"
#include "case/shape_format.hpp"
#include "generators/random.hpp"
#include "properties/numbers.hpp"
#include "properties/shrink/simpler_numbers.hpp"

namespace rayproof::shrink_moves {

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

}  // namespace

void drop_parts(const Case& best, const Try& attempt) {
  if (!std::holds_alternative<RayQuestion>(best.question)) return;
  const auto ray_of = [](Case& one) -> Ray<double>& { return std::get<RayQuestion>(one.question).ray; };
  attempt_changed(best, attempt, [](Case& one) { std::get<RayQuestion>(one.question).transform.reset(); });
  for (const auto& [t_min, t_max] :
       {std::pair{0.0, infinity<double>}, std::pair{-infinity<double>, infinity<double>}})
    attempt_changed(best, attempt, [&, low = t_min, high = t_max](Case& one) {
      ray_of(one).t_min = low;
      ray_of(one).t_max = high;
    });
}

void drop_vertices(const Case& best, const Try& attempt) {
  // Calls `change` with the list of vertices, if the case has one.
  const auto with_vertices = [](Case& one, const auto& change) {
    if (auto* place = std::get_if<PointAndPolygon<double>>(&one.question)) return change(place->vertices);
    auto* asked = std::get_if<RayQuestion>(&one.question);
    auto* polygon = asked == nullptr ? nullptr : std::get_if<Polygon<double>>(&asked->shape);
    if (polygon != nullptr) change(polygon->vertices);
  };
  const auto count = [&] {
    std::size_t size = 0;
    Case copy = best;
    with_vertices(copy, [&](const auto& vertices) { size = vertices.size(); });
    return size;
  };
  for (std::size_t run = count() / 2; run > 0; run /= 2) {
    for (std::size_t i = 0; i + run <= count(); ++i) {
      attempt_changed(best, attempt, [&](Case& one) {
        with_vertices(one, [&](auto& vertices) {
          const auto from = vertices.begin() + static_cast<std::ptrdiff_t>(i);
          vertices.erase(from, from + static_cast<std::ptrdiff_t>(run));
        });
      });
    }
  }
}

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

void simplify_one(const Case& best, const Try& attempt) {
  for (std::size_t i = 0; i < count_numbers(best); ++i)
    for (const double simpler : simpler_numbers(number_in(best, i), best.precision))
      attempt_changed(best, attempt, [&](Case& one) { number(one, i) = simpler; });
}

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

}  // namespace rayproof::shrink_moves
