#include "properties/diagnosis/models/space/coordinates.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "case/each_number.hpp"
#include "case/json/number_text.hpp"

namespace rayproof::diagnosis {
namespace {

bool names_directions(std::string_view field) {
  return field == "normal" || field == "u" || field == "v" || field == "edges";
}

/// Calls `act` for each vector among the shape's points, or directions.
template <class Act>
void for_each_vector(Shape& shape, bool are_directions, Act&& act) {
  const auto visit_field = [&](std::string_view name, auto& value) {
    using Value = std::remove_reference_t<decltype(value)>;
    if (names_directions(name) != are_directions) return;
    if constexpr (std::is_same_v<Value, glm::dvec3>)
      act(value);
    else if constexpr (requires { std::ranges::for_each(value, act); })
      std::ranges::for_each(value, act);
  };
  std::visit([&]<class S>(S& some) { ShapeFormat<S>::fields(some, visit_field); }, shape);
}

}  // namespace

std::vector<Case> with_vectors(const Case& one, Vectors which, void (*change)(glm::dvec3&)) {
  return with_question(one, [&](RayQuestion& asked) {
    if (which == Vectors::origin)
      change(asked.ray.origin);
    else if (which == Vectors::direction)
      change(asked.ray.direction);
    else
      for_each_vector(asked.shape, which == Vectors::directions, change);
    return true;
  });
}

std::vector<Case> place_ignored(const Case& one) {
  return with_question(one, [](RayQuestion& asked) {
    std::optional<glm::dvec3> place;
    for_each_vector(asked.shape, false, [&](glm::dvec3& point) {
      if (!place) place = point;
      point -= *place;
    });
    return place && *place != glm::dvec3(0);
  });
}

std::vector<Case> with_numbers_of_shape(const Case& one, double (*change)(double x)) {
  if (std::holds_alternative<PointAndPolygon<double>>(one.question)) {
    Case changed = one;
    each_number(std::get<PointAndPolygon<double>>(changed.question), [change](double& x) { x = change(x); });
    return if_valid(std::move(changed));
  }
  return with_question(one, [change](RayQuestion& asked) {
    std::visit([change](auto& shape) { each_number(shape, [change](double& x) { x = change(x); }); },
               asked.shape);
    return true;
  });
}

bool has_moved_number(const Case& one, double (*change)(double x)) {
  bool is_moved = false;
  const auto look = [&](double x) { is_moved = is_moved || (change(x) != 0 && change(x) != x); };
  if (const auto* place = std::get_if<PointAndPolygon<double>>(&one.question)) each_number(*place, look);
  if (const RayQuestion* asked = ray_question(one))
    std::visit([&](const auto& shape) { each_number(shape, look); }, asked->shape);
  return is_moved;
}

std::vector<Case> without_exponents(const Case& one) {
  Case changed = one;
  bool has_exponent = false;
  for (const CaseNumber& number : numbers_of(changed)) {
    std::string text;
    append_number(text, *number.value, one.precision);
    const std::size_t exponent = text.find("e");
    if (!std::isfinite(*number.value) || exponent == std::string::npos) continue;
    *number.value = parse_number(std::string_view(text).substr(0, exponent)).value_or(*number.value);
    has_exponent = true;
  }
  return has_exponent ? if_valid(std::move(changed)) : std::vector<Case>{};
}

Answers whole_numbers_in_32_bits(const Case& one, const Answer& exact) {
  constexpr double least = -0x1p31, span = 0x1p32, largest = 0x1p31 - 1;
  double (*const readings[])(double) = {[](double x) { return x - span * std::floor((x - least) / span); },
                                        [](double x) { return x < 0 ? least : largest; },
                                        [](double) { return least; }};
  Answers answers;
  for (const auto& read : readings) {
    Case changed = one;
    bool is_changed = false;
    for (const CaseNumber& number : numbers_of(changed)) {
      double& x = *number.value;
      std::string text;
      append_number(text, x, one.precision);
      const bool is_whole = text.find_first_not_of("-0123456789") == std::string::npos;
      if (!is_whole || (least <= x && x <= largest)) continue;
      x = read(x);
      is_changed = true;
    }
    if (!is_changed) return {};
    changed.precision = Precision::float64;  // the integer that it is
    const std::vector<Case> valid = if_valid(std::move(changed));
    answers.push_back(valid.empty() ? exact : oracle::answer(valid.front()));
  }
  return answers;
}

bool has_area_cut_off(const Case& one, const Answer& /*exact*/) {
  const auto* place = std::get_if<PointAndPolygon<double>>(&one.question);
  if (place == nullptr) return true;
  const Vec2<double> first = place->vertices.front();
  bool is_wide = false, is_high = false;
  for (const Vec2<double>& vertex : place->vertices) {
    is_wide = is_wide || std::trunc(vertex.x) != std::trunc(first.x);
    is_high = is_high || std::trunc(vertex.y) != std::trunc(first.y);
  }
  return is_wide && is_high;
}

Answers with_shape_cut_off(const Case& one, const Answer& exact) {
  if (!has_area_cut_off(one, exact)) return {Position::outside, Position::boundary};
  return off_boundary_read_as<shape_cut_off>(one, exact);
}

Answers with_shape_in_float(const Case& one, const Answer& exact) {
  const Answers answers = off_boundary_read_as<numbers_in_float>(one, exact);
  const RayQuestion* asked = ray_question(one);
  if (!answers.empty() || asked == nullptr) return answers;
  bool is_too_large = false;
  std::visit(
      [&](const auto& shape) {
        each_number(shape, [&](double x) { is_too_large |= !std::isfinite(static_cast<float>(x)); });
      },
      asked->shape);
  return is_too_large ? Answers{RayAnswer{}, exact} : Answers{};
}

std::vector<Case> without_origin(const Case& one) {
  return with_vectors(one, Vectors::origin, [](glm::dvec3& origin) { origin = glm::dvec3(0); });
}

std::vector<Case> direction_as_origin(const Case& one) {
  std::vector<Case> readings;
  for (const bool is_apart_along_axes : {false, true}) {
    const auto read = with_question(one, [&](RayQuestion& asked) {
      auto& [origin, direction, t_min, t_max] = asked.ray;
      for (int axis = 0; axis < 3; ++axis)
        if (direction[axis] != 0 || !is_apart_along_axes) origin[axis] = direction[axis];
      return true;
    });
    readings.insert(readings.end(), read.begin(), read.end());
  }
  return readings;
}

std::vector<Case> direction_from_shape(const Case& one) {
  return with_question(one, [](RayQuestion& asked) {
    const std::optional<glm::dvec3> place = some_point(asked.shape);
    if (place) asked.ray.direction -= glm::dmat3(asked.transform.value_or(glm::dmat4(1))) * *place;
    return place.has_value();
  });
}

std::vector<Case> direction_as_target(const Case& one) {
  return with_question(one, [](RayQuestion& asked) {
    asked.ray.direction -= asked.ray.origin;
    return asked.ray.origin != glm::dvec3(0);
  });
}

std::vector<Case> with_point(const Case& one, double (*change)(double x, double cells), double cells) {
  Case changed = one;
  auto* place = std::get_if<PointAndPolygon<double>>(&changed.question);
  if (place == nullptr) return {};
  place->point.x = change(place->point.x, cells);
  place->point.y = change(place->point.y, cells);
  return if_finite(std::move(changed));
}

std::vector<Case> point_cut_off(const Case& one) {
  return with_point(
      one, [](double x, double) { return std::trunc(x); }, 1);
}

std::vector<Case> point_exchanged(const Case& one) {
  Case changed = one;
  auto* place = std::get_if<PointAndPolygon<double>>(&changed.question);
  if (place == nullptr) return {};
  std::swap(place->point.x, place->point.y);
  return {changed};
}

}  // namespace rayproof::diagnosis
