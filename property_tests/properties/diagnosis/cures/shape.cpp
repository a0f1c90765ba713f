#include <algorithm>

#include "properties/diagnosis/cures/cures.hpp"

namespace rayproof::diagnosis {
namespace {

bool reverse(Triangle<double>& triangle) {
  std::swap(triangle.b, triangle.c);
  return true;
}
bool reverse(Polygon<double>& polygon) {
  std::reverse(polygon.vertices.begin() + 1, polygon.vertices.end());
  return true;
}
bool reverse(ImplicitPlane& plane) {
  plane.normal = -plane.normal;
  plane.d = -plane.d;
  return true;
}
bool reverse(PointNormalPlane& plane) {
  plane.normal = -plane.normal;
  return true;
}
bool reverse(ParametricPlane& plane) {
  std::swap(plane.u, plane.v);
  return true;
}
bool reverse(Parallelepiped<double>& solid) {
  std::swap(solid.edges[0], solid.edges[1]);
  return true;
}
template <class S>
bool reverse(S& /*has no winding*/) {
  return false;
}

/// x, y, z become y, z, x.
void rename(glm::dvec3& v) { v = {v.y, v.z, v.x}; }

/// The ray and the shape with every vector moved by a linear map, if the shape has no axes of its own.
template <class Move>
bool move_vectors(RayQuestion& asked, Move&& move) {
  if (asked.transform || std::holds_alternative<Cylinder<double>>(asked.shape)) return false;
  move(asked.ray.origin);
  move(asked.ray.direction);
  const auto move_field = [&](const char* /*name*/, auto& value) {
    using Value = std::remove_reference_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, glm::dvec3>)
      move(value);
    else if constexpr (requires { std::ranges::for_each(value, move); })
      std::ranges::for_each(value, move);
  };
  std::visit([&]<class S>(S& shape) { ShapeFormat<S>::fields(shape, move_field); }, asked.shape);
  return true;
}

bool rename_axes(RayQuestion& asked) { return move_vectors(asked, rename); }

}  // namespace

Cases other_first_vertex(const Case& one) {
  Cases all;
  const auto changed_by = [&](std::size_t by) {
    const auto turn = [by](auto& vertices) {
      if (by >= vertices.size()) return false;
      std::rotate(vertices.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(by), vertices.end());
      return true;
    };
    if (auto changed = one; auto* place = std::get_if<PointAndPolygon<double>>(&changed.question))
      return turn(place->vertices) ? if_valid(std::move(changed)) : Cases{};
    return with_shape<Polygon<double>>(
        one, [&](RayQuestion& /*asked*/, Polygon<double>& polygon) { return turn(polygon.vertices); });
  };
  constexpr std::size_t most = 8;  // of a large polygon some are enough
  for (std::size_t by = 1; by <= most; ++by) {
    const Cases some = changed_by(by);
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

Cases reversed_winding(const Case& one) {
  if (auto changed = one; auto* place = std::get_if<PointAndPolygon<double>>(&changed.question)) {
    std::reverse(place->vertices.begin() + 1, place->vertices.end());
    return if_valid(std::move(changed));
  }
  return with_question(one, [](RayQuestion& asked) {
    return std::visit([](auto& shape) { return reverse(shape); }, asked.shape);
  });
}

Cases renamed_axes(const Case& one) {
  Cases all = with_question(one, rename_axes);
  if (all.empty()) return {};
  for (const Case& twice : with_question(all.front(), rename_axes)) all.push_back(twice);
  return all;
}

Cases turned(const Case& one) {
  return with_question(one, [](RayQuestion& asked) {
    // The columns of a rotation, in fifteenths.
    const glm::dmat3 rotation(10.0 / 15, 11.0 / 15, 2.0 / 15, -5.0 / 15, 2.0 / 15, 14.0 / 15, 10.0 / 15,
                              -10.0 / 15, 5.0 / 15);
    return !std::holds_alternative<Box<double>>(asked.shape) &&
           move_vectors(asked, [&](glm::dvec3& v) { v = rotation * v; });
  });
}

Cases unit_normal(const Case& one) {
  return with_question(one, [](RayQuestion& asked) {
    if (auto* plane = std::get_if<ImplicitPlane>(&asked.shape)) {
      const double length = glm::length(plane->normal);
      *plane = {plane->normal / length, plane->d / length};
      return length != 1;
    }
    auto* plane = std::get_if<PointNormalPlane>(&asked.shape);
    if (plane != nullptr) plane->normal = glm::normalize(plane->normal);
    return plane != nullptr;
  });
}

Cases unit_edges(const Case& one) {
  return with_shape<Parallelepiped<double>>(one, [](RayQuestion& /*asked*/, Parallelepiped<double>& solid) {
    for (glm::dvec3& edge : solid.edges) edge = glm::normalize(edge);
    return true;
  });
}

}  // namespace rayproof::diagnosis
