#include "properties/diagnosis/models/first_hit/normals.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "oracle/oracle.hpp"
#include "properties/claims/answers.hpp"
#include "properties/diagnosis/examination/agreement.hpp"
#include "properties/diagnosis/models/first_hit/points.hpp"
#include "properties/diagnosis/models/first_hit/surface_normals.hpp"
#include "properties/edges.hpp"

namespace rayproof::diagnosis {
namespace {

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

Answers normal_of_far_hit(const Case& one, const Answer& exact) {
  const auto* answer = std::get_if<RayAnswer>(&exact);
  if (ray_question(one) == nullptr || answer == nullptr || answer->hits.count == 0) return {};
  const HitList line = hits_of_line(one).hits;
  if (line.count < 2 || answer->hits.t[0] != line.t[0]) return {};
  Case back = on_whole_line(one);  // of the ray that runs back the far hit is the first
  Ray<double>& ray = std::get<RayQuestion>(back.question).ray;
  ray.direction = -ray.direction;
  const std::vector<glm::dvec3> normals = normals_of_first_hit(back, oracle::answer(back));
  if (normals.empty()) return {};
  RayAnswer other = *answer;
  other.normal = normals.front();
  const bool heads_to_middle = line.t[0] + line.t[1] > 0;
  return {other, heads_to_middle ? Answer{other} : exact, heads_to_middle ? exact : Answer{other}};
}

Answers normal_of_other_hit(const Case& one, const Answer& exact) {
  Answers near = normal_of_near_hit(one, exact);
  if (!near.empty()) return near;
  const Answers far = normal_of_far_hit(one, exact);
  return far.empty() ? Answers{} : Answers{far.front()};
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

Answers normal_about_mean(const Case& one, const Answer& exact) {
  const auto* polygon = shape_in<Polygon<double>>(one);
  const auto* answer = std::get_if<RayAnswer>(&exact);
  if (polygon == nullptr || answer == nullptr || !answer->normal) return {};
  const auto& v = polygon->vertices;
  const glm::dvec3 mean = mean_of(v);
  Answers answers;
  for (const std::size_t i : {std::size_t{0}, v.size() - 1, std::size_t{1}}) {
    const glm::dvec3 normal = glm::cross(v[i] - mean, v[(i + 1) % v.size()] - mean);
    RayAnswer other = *answer;
    if (normal != glm::dvec3(0)) other.normal = glm::normalize(map_of_normals(*ray_question(one)) * normal);
    answers.emplace_back(other);
  }
  return answers;
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

Answers normal_by_columns(const Case& one, const Answer& exact) {
  if (!has_transform(one)) return {};
  return with_normal(one, exact, [](const RayQuestion& asked, const glm::dvec3& normal) {
    glm::dmat3 columns = linear(asked);
    for (int i = 0; i < 3; ++i) columns[i] /= glm::dot(columns[i], columns[i]);
    return columns * normal_in_object_space(asked, normal);
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

}  // namespace rayproof::diagnosis
