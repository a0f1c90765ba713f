/// \file
/// Handles by the fields of the case format: a point is a point, a vector's tip lies beyond the shape's
/// point, a length ends on its axis.

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <string_view>
#include <variant>

#include "viz/player/player.hpp"

namespace rayproof::viz {
namespace {

/// A field of a shape, or an element of one that is a list.
struct Part {
  std::string name;
  std::variant<glm::dvec3*, Vec2<double>*, double*> value;
};

/// Gathers the parts of whatever ShapeFormat's fields hand over.
struct Gather {
  std::vector<Part>& parts;
  void operator()(const char* name, glm::dvec3& v) { parts.push_back({name, &v}); }
  void operator()(const char* name, Vec2<double>& v) { parts.push_back({name, &v}); }
  void operator()(const char* name, double& x) { parts.push_back({name, &x}); }
  void operator()(const char* /*name*/, bool& /*nothing to hold*/) {}
  template <class List>
  void operator()(const char* name, List& list) {
    for (std::size_t i = 0; i < list.size(); ++i) (*this)(fmt::format("{} {}", name, i + 1).c_str(), list[i]);
  }
};

std::vector<Part> parts_of(Case& one) {
  std::vector<Part> parts;
  if (auto* asked = std::get_if<RayQuestion>(&one.question)) {
    std::visit([&]<class S>(S& shape) { ShapeFormat<S>::fields(shape, Gather{parts}); }, asked->shape);
  } else if (auto* polygon = std::get_if<PointAndPolygon<double>>(&one.question)) {
    ShapeFormat<PointAndPolygon<double>>::fields(*polygon, Gather{parts});
  }
  return parts;
}

bool is_vector(std::string_view name) {
  return name == "normal" || name == "u" || name == "v" || name.starts_with("edges");
}

/// The point of the shape from which its vectors and lengths are seen: its first one, of an implicit plane
/// the one nearest the world's origin.
glm::dvec3 base_of(const RayQuestion& asked, const std::vector<Part>& parts) {
  if (const auto* plane = std::get_if<ImplicitPlane>(&asked.shape))
    return -plane->d / glm::dot(plane->normal, plane->normal) * plane->normal;
  const auto* const first = parts.empty() ? nullptr : std::get_if<glm::dvec3*>(&parts.front().value);
  return first != nullptr && !is_vector(parts.front().name) ? **first : glm::dvec3(0);
}

/// Where a part can be held, and what becomes of it when that moves; all in the shape's own space.
struct Grip {
  glm::dvec3 at{};
  std::function<void(const Part& part, const glm::dvec3& to, const Rounding& round)> move{};
};

Grip point_grip(const glm::dvec3& at) {
  return {at, [](const Part& part, const glm::dvec3& to, const Rounding& round) {
            if (auto* const* flat = std::get_if<Vec2<double>*>(&part.value)) {
              **flat = {round((*flat)->x, to.x), round((*flat)->y, to.y)};
            } else {
              glm::dvec3& p = *std::get<glm::dvec3*>(part.value);
              p = round(p, to);
            }
          }};
}

/// A vector far longer or shorter than the view is held at a place on its line.
Grip vector_grip(const glm::dvec3& base, const glm::dvec3& vector, double size) {
  const double length = glm::length(vector);
  const double share = length > 0.2 * size && length < 1.2 * size ? 1 : 0.6 * size / length;
  return {base + share * vector,
          [base, share](const Part& part, const glm::dvec3& to, const Rounding& round) {
            glm::dvec3& v = *std::get<glm::dvec3*>(part.value);
            v = round.magnified(share)(v, (to - base) / share);
          }};
}

Grip length_grip(const glm::dvec3& base, double length, const glm::dvec3& along, bool is_radius) {
  return {base + length * along,
          [base, along, is_radius](const Part& part, const glm::dvec3& to, const Rounding& round) {
            double& x = *std::get<double*>(part.value);
            x = round(x, is_radius ? glm::length(to - base) : glm::dot(to - base, along));
          }};
}

/// The d of a plane, by the plane's point.
Grip offset_grip(const glm::dvec3& base, const glm::dvec3& normal) {
  return {base, [normal](const Part& part, const glm::dvec3& to, const Rounding& round) {
            double& d = *std::get<double*>(part.value);
            d = round.magnified(1 / glm::length(normal))(d, -glm::dot(normal, to));
          }};
}

Grip grip_of(const Part& part, const RayQuestion* asked, const glm::dvec3& base, double size,
             const glm::dvec3& aside) {
  if (auto* const* flat = std::get_if<Vec2<double>*>(&part.value))
    return point_grip({(*flat)->x, (*flat)->y, 0});
  if (auto* const* point = std::get_if<glm::dvec3*>(&part.value))
    return is_vector(part.name) ? vector_grip(base, **point, size) : point_grip(**point);
  const double length = *std::get<double*>(part.value);
  if (part.name == "d") return offset_grip(base, std::get<ImplicitPlane>(asked->shape).normal);
  if (part.name == "radius") return length_grip(base, length, aside, true);
  const glm::dvec3 axis(part.name == "rx", part.name == "ry", part.name == "height");
  return length_grip(base, length, axis, false);
}

/// The translation, and the tips of the three axes a little beyond the unit, where a unit shape has nothing.
void add_matrix_handles(std::vector<Handle>& handles, const glm::dmat4& matrix) {
  constexpr double beyond = 1.25;
  const auto matrix_of = [](Case& next) -> glm::dmat4& {
    return *std::get<RayQuestion>(next.question).transform;
  };
  const glm::dvec3 origin(matrix[3]);
  handles.push_back(
      {"translation", origin, [matrix_of](Case& next, const glm::dvec3& to, const Rounding& round) {
         glm::dmat4& m = matrix_of(next);
         m[3] = glm::dvec4(round(glm::dvec3(m[3]), to), 1);
       }});
  for (int axis = 0; axis < 3; ++axis) {
    handles.push_back({fmt::format("{} axis", "xyz"[axis]), origin + beyond * glm::dvec3(matrix[axis]),
                       [=](Case& next, const glm::dvec3& to, const Rounding& round) {
                         glm::dmat4& m = matrix_of(next);
                         const glm::dvec3 column = (to - origin) / beyond;
                         m[axis] = glm::dvec4(round(glm::dvec3(m[axis]), column), 0);
                       }});
  }
}

}  // namespace

std::vector<Handle> shape_handles(const Case& one, double size, const glm::dvec3& aside) {
  Case copy = one;
  const std::vector<Part> parts = parts_of(copy);
  const auto* const asked = std::get_if<RayQuestion>(&copy.question);
  const bool is_transformed = asked != nullptr && asked->transform.has_value();
  const glm::dmat4 to_world = is_transformed ? *asked->transform : glm::dmat4(1);
  const glm::dmat4 to_object = glm::inverse(to_world);
  const double scale = std::cbrt(std::abs(glm::determinant(to_world)));
  const glm::dvec3 base = asked != nullptr ? base_of(*asked, parts) : glm::dvec3(0);
  std::vector<Handle> handles;
  if (is_transformed) add_matrix_handles(handles, to_world);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Grip grip = grip_of(parts[i], asked, base, size / scale, aside);
    handles.push_back({parts[i].name, glm::dvec3(to_world * glm::dvec4(grip.at, 1)),
                       [=](Case& next, const glm::dvec3& to, const Rounding& round) {
                         grip.move(parts_of(next).at(i), glm::dvec3(to_object * glm::dvec4(to, 1)),
                                   round.magnified(scale));
                       }});
  }
  return handles;
}

}  // namespace rayproof::viz
