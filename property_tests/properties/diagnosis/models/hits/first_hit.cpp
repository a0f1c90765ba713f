#include "properties/diagnosis/models/hits/first_hit.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/examination/agreement.hpp"
#include "properties/diagnosis/models/surface_normals.hpp"
#include "properties/edges.hpp"

namespace rayproof::diagnosis {
namespace {

Answers with_point(const Answer& exact, const glm::dvec3& point) {
  RayAnswer other = std::get<RayAnswer>(exact);
  other.point = point;
  return {other};
}

const RayAnswer* hit_with_point(const Answer& exact) {
  const auto* answer = std::get_if<RayAnswer>(&exact);
  return answer != nullptr && answer->point ? answer : nullptr;
}

bool has_transform(const Case& one) {
  return ray_question(one) != nullptr && ray_question(one)->transform.has_value();
}

}  // namespace

Answers normal_faces_ray(const Case& one, const Answer& exact) {
  return with_normal(one, exact, [](const RayQuestion& asked, const glm::dvec3& normal) {
    return glm::dot(normal, asked.ray.direction) > 0 ? -normal : normal;
  });
}

Answers normal_is_direction(const Case& one, const Answer& exact) {
  return with_normal(one, exact, [](const RayQuestion& asked, const glm::dvec3& /*normal*/) {
    return map_of_normals(asked) * -ray_in_object(asked).direction;
  });
}

Answers normal_follows_ray(const Case& one, const Answer& exact) {
  return with_normal(one, exact, [](const RayQuestion& asked, const glm::dvec3& normal) {
    return glm::dot(normal, asked.ray.direction) < 0 ? -normal : normal;
  });
}

Answers normal_flipped(const Case& one, const Answer& exact) {
  return with_normal(one, exact,
                     [](const RayQuestion& /*asked*/, const glm::dvec3& normal) { return -normal; });
}

Answers normal_flipped_by_mirror(const Case& one, const Answer& exact) {
  const auto* asked = ray_question(one);
  const bool is_mirrored = asked != nullptr && asked->transform && glm::determinant(linear(*asked)) < 0;
  return is_mirrored ? normal_flipped(one, exact) : Answers{};
}

Answers normal_flipped_by_edges(const Case& one, const Answer& exact) {
  const auto* solid = shape_in<Parallelepiped<double>>(one);
  if (solid == nullptr) return {};
  const auto& [e, f, g] = solid->edges;
  return glm::dot(e, glm::cross(f, g)) < 0 ? normal_flipped(one, exact) : Answers{};
}

Answers normal_of_near_hit(const Case& one, const Answer& exact) {
  if (ray_question(one) == nullptr || !finds_something(exact)) return {};
  const RayAnswer line = hits_of_line(one);
  if (line.hits.count < 2 || std::get<RayAnswer>(exact).hits.t[0] == line.hits.t[0]) return {};
  Answers answers;
  for (const glm::dvec3& normal : normals_of_first_hit(on_whole_line(one), line)) {
    RayAnswer other = std::get<RayAnswer>(exact);
    other.normal = normal;
    answers.emplace_back(other);
  }
  return answers;
}

std::optional<bool> normal_not_unit(const Case& one, const Answer& got, const Answer& exact) {
  const auto *mine = std::get_if<RayAnswer>(&got), *answer = std::get_if<RayAnswer>(&exact);
  if (mine == nullptr || answer == nullptr || !mine->normal) return std::nullopt;
  const double length = glm::length(*mine->normal);
  if (are_close(one.precision, length, 1, 0)) return std::nullopt;
  return std::ranges::any_of(normals_of_first_hit(one, exact), [&](const glm::dvec3& normal) {
    return glm::length(*mine->normal / length - normal) < 0x1p-8;
  });
}

Answers normal_of_first_corner(const Case& one, const Answer& exact) {
  const auto* polygon = shape_in<Polygon<double>>(one);
  if (polygon == nullptr) return {};
  return with_normal(one, exact, [&](const RayQuestion& asked, const glm::dvec3& normal) {
    const auto& v = polygon->vertices;
    const glm::dvec3 corner = glm::cross(v[1] - v[0], v[2] - v[0]);
    return glm::dot(corner, normal_in_object_space(asked, normal)) < 0 ? -normal : normal;
  });
}

std::optional<bool> normal_of_other_face(const Case& one, const Answer& got, const Answer& exact) {
  if (shape_in<Box<double>>(one) == nullptr || agree(one, got, exact, Aspect::normal)) return std::nullopt;
  const auto* mine = std::get_if<RayAnswer>(&got);
  if (mine == nullptr || !mine->normal) return std::nullopt;
  const glm::dvec3 normal = normal_in_object_space(*ray_question(one), *mine->normal);
  const double largest = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
  for (int axis = 0; axis < 3; ++axis)  // -1, 0 or 1 along each axis
    if (const double x = std::abs(normal[axis]) / largest; !(x < 0x1p-10 || x > 1 - 0x1p-10)) return false;
  return true;
}

Answers normal_in_object(const Case& one, const Answer& exact) {
  if (!has_transform(one)) return {};
  return with_normal(one, exact, normal_in_object_space);
}

Answers normal_by_matrix(const Case& one, const Answer& exact) {
  if (!has_transform(one)) return {};
  return with_normal(one, exact, [](const RayQuestion& asked, const glm::dvec3& normal) {
    return linear(asked) * normal_in_object_space(asked, normal);
  });
}

Answers normal_by_inverse(const Case& one, const Answer& exact) {
  if (!has_transform(one)) return {};
  return with_normal(one, exact, [](const RayQuestion& asked, const glm::dvec3& normal) {
    return glm::inverse(linear(asked)) * normal_in_object_space(asked, normal);
  });
}

Answers normal_moved(const Case& one, const Answer& exact) {
  if (!has_transform(one)) return {};
  Answers answers;
  for (const bool is_by_matrix : {false, true}) {
    const auto move = [is_by_matrix](const RayQuestion& asked, const glm::dvec3& normal) {
      const glm::dvec3 own = glm::normalize(normal_in_object_space(asked, normal));
      const glm::dmat3 carried = is_by_matrix ? linear(asked) : map_of_normals(asked);
      return carried * own + glm::dvec3((*asked.transform)[3]);
    };
    std::ranges::move(with_normal(one, exact, move), std::back_inserter(answers));
  }
  return answers;
}

Answers normal_from_zero(const Case& one, const Answer& exact) {
  const RayAnswer* answer = hit_with_point(exact);
  if (answer == nullptr) return {};
  return with_normal(
      one, exact, [&](const RayQuestion& /*asked*/, const glm::dvec3& /*normal*/) { return *answer->point; });
}

Answers normal_from_middle(const Case& one, const Answer& exact) {
  const RayAnswer* answer = hit_with_point(exact);
  if (answer == nullptr) return {};
  const Shape& shape = ray_question(one)->shape;
  glm::dvec3 middle;
  if (const auto* box = std::get_if<Box<double>>(&shape))
    middle = 0.5 * (box->min + box->max);
  else if (const auto* solid = std::get_if<Parallelepiped<double>>(&shape))
    middle = solid->corner + 0.5 * (solid->edges[0] + solid->edges[1] + solid->edges[2]);
  else if (const auto* cylinder = std::get_if<Cylinder<double>>(&shape))
    middle = {0, 0, cylinder->height / 2};
  else
    return {};
  const glm::dvec3 way = point_at(ray_in_object(*ray_question(one)), answer->hits.t[0]) - middle;
  return with_normal(one, exact, [&](const RayQuestion& asked, const glm::dvec3& /*normal*/) {
    return map_of_normals(asked) * way;
  });
}

Answers normal_without_signs(const Case& one, const Answer& exact) {
  Answers in_world = with_normal(
      one, exact, [](const RayQuestion& /*asked*/, const glm::dvec3& normal) { return glm::abs(normal); });
  const Answers in_object = with_normal(one, exact, [](const RayQuestion& asked, const glm::dvec3& normal) {
    return map_of_normals(asked) * glm::abs(normal_in_object_space(asked, normal));
  });
  in_world.insert(in_world.end(), in_object.begin(), in_object.end());
  return in_world;
}

Answers point_in_object(const Case& one, const Answer& exact) {
  const RayAnswer* answer = hit_with_point(exact);
  if (answer == nullptr || !ray_question(one)->transform) return {};
  return with_point(exact, point_at(ray_in_object(*ray_question(one)), answer->hits.t[0]));
}

Answers point_without_origin(const Case& one, const Answer& exact) {
  const RayAnswer* answer = hit_with_point(exact);
  return answer == nullptr ? Answers{}
                           : with_point(exact, answer->hits.t[0] * ray_question(one)->ray.direction);
}

Answers point_against_direction(const Case& one, const Answer& exact) {
  const RayAnswer* answer = hit_with_point(exact);
  return answer == nullptr ? Answers{}
                           : with_point(exact, point_at(ray_question(one)->ray, -answer->hits.t[0]));
}

Answers point_by_unit_direction(const Case& one, const Answer& exact) {
  const RayAnswer* answer = hit_with_point(exact);
  if (answer == nullptr) return {};
  Answers answers;
  for (const Ray<double>& ray : {ray_question(one)->ray, ray_in_object(*ray_question(one))}) {
    const double length = glm::length(ray.direction);  // in the world, or in object space
    answers.push_back(
        with_point(exact, point_at(ray_question(one)->ray, answer->hits.t[0] / length)).front());
  }
  return answers;
}

Answers point_from_shape(const Case& one, const Answer& exact) {
  const RayAnswer* answer = hit_with_point(exact);
  const auto place = answer == nullptr ? std::nullopt : some_point(ray_question(one)->shape);
  return place ? with_point(exact, *answer->point - *place) : Answers{};
}

Answers point_of_far_hit(const Case& one, const Answer& exact) {
  const RayAnswer* answer = hit_with_point(exact);
  if (answer == nullptr || answer->hits.count < 2) return {};
  return with_point(exact, point_at(ray_question(one)->ray, answer->hits.t[1]));
}

std::optional<bool> point_moved_along_normal(const Case& one, const Answer& got, const Answer& exact) {
  const auto* mine = std::get_if<RayAnswer>(&got);
  const RayAnswer* answer = hit_with_point(exact);
  if (mine == nullptr || answer == nullptr || !mine->point || !answer->normal) return std::nullopt;
  const glm::dvec3 way = *mine->point - *answer->point;
  const double along = glm::dot(way, *answer->normal), far = size_of_scene(one);
  if (std::abs(along) <= 64 * share_of_rounding(one.precision) * far) return std::nullopt;
  return glm::length(way - along * *answer->normal) <= 0x1p-6 * std::abs(along);
}

std::optional<bool> point_beside_ray(const Case& one, const Answer& got, const Answer& exact) {
  const auto* mine = std::get_if<RayAnswer>(&got);
  if (mine == nullptr || !mine->point || !finds_something(exact)) return std::nullopt;
  const Ray<double>& ray = ray_question(one)->ray;
  const glm::dvec3 way = *mine->point - ray.origin, along = glm::normalize(ray.direction);
  const double apart = glm::length(way - glm::dot(way, along) * along);
  return apart > 0x1p-10 * std::max(size_of_scene(one), glm::length(*mine->point));
}

std::optional<bool> point_right_t_wrong(const Case& one, const Answer& got, const Answer& exact) {
  const auto* mine = std::get_if<RayAnswer>(&got);
  const RayAnswer* answer = hit_with_point(exact);
  if (mine == nullptr || answer == nullptr || !mine->point) return std::nullopt;
  if (mine->hits.count == 0 || are_close(one.precision, mine->hits.t[0], answer->hits.t[0], 0))
    return std::nullopt;
  return agree(one, got, exact, Aspect::point);
}

Answers weights_and_t(const Case& /*one*/, const Answer& exact) {
  const auto* answer = std::get_if<RayAnswer>(&exact);
  if (answer == nullptr || !answer->barycentric) return {};
  RayAnswer shifted = *answer;
  shifted.barycentric = {answer->barycentric->y, answer->barycentric->z, answer->hits.t[0]};
  return {shifted};
}

}  // namespace rayproof::diagnosis
