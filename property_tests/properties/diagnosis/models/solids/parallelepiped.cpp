#include "properties/diagnosis/models/solids/parallelepiped.hpp"

#include <cmath>

#include "properties/claims/answers.hpp"
#include "properties/edges.hpp"

namespace rayproof::diagnosis {

std::vector<Case> parallelepiped_as_box(const Case& one) {
  return with_question(one, [](RayQuestion& asked) {
    const auto* solid = std::get_if<Parallelepiped<double>>(&asked.shape);
    if (solid == nullptr) return false;
    const glm::dvec3 a = solid->corner;
    const glm::dvec3 b = a + solid->edges[0] + solid->edges[1] + solid->edges[2];
    asked.shape = Box<double>{glm::min(a, b), glm::max(a, b)};
    return true;
  });
}

std::vector<Case> parallelepiped_as_bounds(const Case& one) {
  return with_question(one, [](RayQuestion& asked) {
    const auto* solid = std::get_if<Parallelepiped<double>>(&asked.shape);
    if (solid == nullptr) return false;
    glm::dvec3 low = solid->corner, high = low;
    for (const glm::dvec3& edge : solid->edges) {
      low += glm::min(edge, glm::dvec3(0));
      high += glm::max(edge, glm::dvec3(0));
    }
    asked.shape = Box<double>{low, high};
    return true;
  });
}

std::vector<Case> edges_times_length(const Case& one) {
  return with_shape<Parallelepiped<double>>(one, [](RayQuestion& /*asked*/, Parallelepiped<double>& solid) {
    for (glm::dvec3& edge : solid.edges) edge *= glm::length(edge);
    return true;
  });
}

std::vector<Case> edges_as_orthogonal(const Case& one) {
  return with_shape<Parallelepiped<double>>(one, [](RayQuestion& /*asked*/, Parallelepiped<double>& solid) {
    const auto& e = solid.edges;
    const glm::dmat3 dual = glm::transpose(glm::inverse(glm::dmat3(e[0], e[1], e[2])));
    for (int i = 0; i < 3; ++i) {
      glm::dvec3& edge = solid.edges.at(static_cast<std::size_t>(i));
      edge = glm::dot(edge, edge) * dual[i];
    }
    return true;
  });
}

std::vector<Case> corner_as_centre(const Case& one) {
  return with_shape<Parallelepiped<double>>(one, [](RayQuestion& /*asked*/, Parallelepiped<double>& solid) {
    solid.corner -= 0.5 * (solid.edges[0] + solid.edges[1] + solid.edges[2]);
    return true;
  });
}

std::vector<Case> edges_as_vertices(const Case& one) {
  return with_shape<Parallelepiped<double>>(one, [](RayQuestion& /*asked*/, Parallelepiped<double>& solid) {
    for (glm::dvec3& edge : solid.edges) edge -= solid.corner;
    return true;
  });
}

Answers small_volume_missed(const Case& one, const Answer& exact, double least) {
  const auto* solid = shape_in<Parallelepiped<double>>(one);
  if (solid == nullptr || !finds_something(exact)) return {};
  const auto& e = solid->edges;
  return std::abs(glm::determinant(glm::dmat3(e[0], e[1], e[2]))) < least ? Answers{RayAnswer{}} : Answers{};
}

Answers flat_solid_missed(const Case& one, const Answer& exact, double share) {
  const auto* solid = shape_in<Parallelepiped<double>>(one);
  if (solid == nullptr) return {};
  const auto& [e, f, g] = solid->edges;
  return small_volume_missed(one, exact, share * glm::length(e) * glm::length(f) * glm::length(g));
}

Answers missed_beside_two_corners(const Case& one, const Answer& exact) {
  const std::vector<Case> boxes = finds_something(exact) ? parallelepiped_as_box(one) : std::vector<Case>{};
  // Bounds may be asked of the line, or of the ray in its interval; what is inside them it does not miss.
  if (boxes.empty() || hits_of_line(boxes.front()).hits.count > 0) return {};
  return {RayAnswer{}};
}

std::vector<Case> edges_along_axes(const Case& one) {
  return with_question(one, [](RayQuestion& asked) {
    const auto* solid = std::get_if<Parallelepiped<double>>(&asked.shape);
    if (solid == nullptr) return false;
    const auto& [x, y, z] = solid->edges;
    const glm::dvec3 size(glm::length(x), glm::length(y), glm::length(z));
    asked.shape = Box<double>{solid->corner, solid->corner + size};
    return true;
  });
}

std::vector<Case> edges_transposed(const Case& one) {
  return with_shape<Parallelepiped<double>>(one, [](RayQuestion& /*asked*/, Parallelepiped<double>& solid) {
    auto& e = solid.edges;
    const glm::dmat3 other = glm::transpose(glm::dmat3(e[0], e[1], e[2]));
    e = {other[0], other[1], other[2]};
    return true;
  });
}

Answers zero_pivot_missed(const Case& one, const Answer& exact) {
  glm::dvec3 first, second;
  if (const auto* solid = shape_in<Parallelepiped<double>>(one)) {
    first = solid->edges[0];
    second = solid->edges[1];
  } else if (const auto* triangle = shape_in<Triangle<double>>(one)) {
    first = triangle->b - triangle->a;
    second = triangle->c - triangle->a;
  } else {
    return {};
  }
  const bool has_zero = first.x == 0 || first.x * second.y == first.y * second.x;
  return has_zero && finds_something(exact) ? Answers{RayAnswer{}} : Answers{};
}

void add_endless_along(const Case& one, int edge, Answers& answers) {
  const auto cube = cube_in(one);
  if (!cube) return;
  const glm::dvec3& d = cube->ray.direction;
  const double rounding = 0x1p-40 * glm::length(d);
  if (std::abs(d[(edge + 1) % 3]) > rounding || std::abs(d[(edge + 2) % 3]) > rounding) return;
  RayAnswer endless;
  for (const double t : {-infinity<double>, infinity<double>})
    if (in_interval(ray_question(one)->ray, t)) endless.hits.push_back(t);
  answers.emplace_back(endless);
  if (endless.hits.count > 0) answers.emplace_back(RayAnswer{});
}

Answers left_handed_missed(const Case& one, const Answer& exact) {
  const auto* solid = shape_in<Parallelepiped<double>>(one);
  if (solid == nullptr || !finds_something(exact)) return {};
  const auto& [e, f, g] = solid->edges;
  return glm::dot(e, glm::cross(f, g)) < 0 ? Answers{RayAnswer{}} : Answers{};
}

Answers edge_of_other_length(const Case& one, const Answer& /*exact*/) {
  Answers answers;
  for (std::size_t edge = 0; edge < 3; ++edge)
    for (const double times : {2.0, 0.5})
      for (Answer& answer :
           exact_of(with_shape<Parallelepiped<double>>(one, [&](RayQuestion& /*asked*/, auto& solid) {
             solid.edges[edge] *= times;
             return true;
           })))
        answers.push_back(std::move(answer));
  return answers.size() == 6 ? answers : Answers{};
}

}  // namespace rayproof::diagnosis
