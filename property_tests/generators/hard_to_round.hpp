#pragma once
/// \file
/// Rays for which a few digits more than the format's own decide nothing: t lies beside the middle of two
/// numbers, or beside an end of the interval, and edges are passed, nearer than twice the digits show.
///
/// All is whole on a grid. How far a ray's t is from a number, and its line from an edge, is then a multiple
/// of a small step, and linear in the ray's origin; so the origin is sought among the whole points of a
/// plane, near the place that it was drawn at. V. Lefèvre and J.-M. Muller seek the hard cases of functions
/// on lattices, too ("Worst Cases for Correct Rounding of the Elementary Functions in Double Precision",
/// 2001).

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "generators/aim.hpp"
#include "generators/lattice.hpp"

namespace rayproof::hard {

using lattice::Whole, lattice::WholeVector;

/// Shape, direction and origin are multiples of 2^-shape, 2^-direction and 2^-origin.
struct Grid {
  int digits, shape, direction, origin;
};
[[nodiscard]] inline Grid grid_of(Precision precision) {
  return precision == Precision::float32 ? Grid{24, 14, 19, 19} : Grid{53, 36, 47, 48};
}

inline constexpr const char* to_round_description =
    "t is beside the middle of two numbers, or an end of the interval, by a part that twice the digits hide";
inline constexpr const char* coordinate_description =
    "a coordinate is beside the middle of two numbers by a part that twice the digits hide, or is it";
inline constexpr const char* to_decide_description =
    "the line passes an edge by a part that twice the digits hide, or exactly through it";
inline constexpr const char* to_meet_description =
    "the ray runs along the surface but for a part that twice the digits hide, or exactly along it";

/// All x with n·x = height, in steps of the shape's grid; n has no common factor.
struct WholePlane {
  WholeVector n;
  Whole height;
};
/// Through a point, along two edges.
[[nodiscard]] inline WholePlane plane_along(const Grid& grid, const glm::dvec3& point, const glm::dvec3& a,
                                            const glm::dvec3& b) {
  const WholeVector n =
      lattice::primitive(lattice::cross(lattice::whole(a, grid.shape), lattice::whole(b, grid.shape)));
  return {n, lattice::dot(n, lattice::whole(point, grid.shape))};
}

/// A distance that is the part 2^-1.5digits to 2^-2.5digits of `size`, or one step; of either sign.
[[nodiscard]] inline Whole next_to_nothing(Random& random, const Whole& size, const Grid& grid) {
  const int bits = static_cast<int>(msb(abs(size))),
            fewer = static_cast<int>(random.uniform(1.5, 2.5) * grid.digits);
  const Whole some = lattice::some_whole(random, bits - fewer);
  return random.one_in(2) ? -some : some;
}

/// The scene of these whole numbers; nothing where the origin has more digits than the precision.
[[nodiscard]] inline std::optional<Scene> scene_of(const Grid& grid, const Shape& shape,
                                                   const WholeVector& origin, const WholeVector& direction) {
  for (const Whole& x : origin)
    if ((abs(x) >> grid.digits) != 0) return std::nullopt;
  return Scene{lattice::vector(origin, grid.origin), lattice::vector(direction, grid.direction), shape};
}

/// A ray to near `target` that meets the plane at a t beside the middle of two numbers; a third of the time
/// beside a number at which its interval ends.
[[nodiscard]] inline std::optional<Scene> to_round(Random& random, const Grid& grid, const Shape& shape,
                                                   const WholePlane& plane, const glm::dvec3& target) {
  const WholeVector direction = lattice::whole(draw::unit_vector(random), grid.direction);
  const Whole along = lattice::dot(plane.n, direction);
  if (along % 2 == 0) return std::nullopt;

  // t is beside M·2^(e - digits). In N steps of the origin along n that is N·2^k = M·along - r.
  const int e = random.between(1, 3), k = grid.direction + grid.digits - e - grid.origin;
  const bool ends_there = random.one_in(3);
  Whole r = next_to_nothing(random, along << grid.digits, grid);
  if (r % 2 == 0) ++r;
  if (ends_there) r *= 2;
  const Whole modulus = Whole(1) << k;
  const Whole M =
      (lattice::some_whole(random, grid.digits + 1 - k) << k) + lattice::quotient_modulo(r, along, modulus);
  const double t = lattice::number(M, grid.digits - e);

  const Whole steps = (plane.height << (grid.origin - grid.shape)) - (M * along - r) / modulus;
  const glm::dvec3 drawn = target - t * lattice::vector(direction, grid.direction);
  const lattice::PlaneLattice points(plane.n);
  auto scene = scene_of(grid, shape, points.point_near(lattice::whole(drawn, grid.origin), steps), direction);
  if (!scene) return scene;
  scene->aimed_at = t;
  if (ends_there) (random.one_in(2) ? scene->t_min : scene->t_max) = t;
  return scene;
}

/// A ray that passes the edge from `corner` along `edge`, near `target`, by next to nothing; an eighth of the
/// time exactly through it.
[[nodiscard]] inline std::optional<Scene> to_decide(Random& random, const Grid& grid, const Shape& shape,
                                                    const glm::dvec3& corner, const glm::dvec3& edge,
                                                    const glm::dvec3& target) {
  const WholeVector direction = lattice::whole(draw::unit_vector(random), grid.direction);
  const WholeVector n = lattice::primitive(lattice::cross(direction, lattice::whole(edge, grid.shape)));
  if (lattice::dot(n, n) == 0) return std::nullopt;
  const Whole size = abs(n[0]) + abs(n[1]) + abs(n[2]);
  const Whole r = random.one_in(8) ? Whole(0) : next_to_nothing(random, size << grid.digits, grid);
  const Whole steps = (lattice::dot(n, lattice::whole(corner, grid.shape)) << (grid.origin - grid.shape)) + r;
  const glm::dvec3 drawn = target - random.uniform(1, 8) * lattice::vector(direction, grid.direction);
  return scene_of(grid, shape, lattice::PlaneLattice(n).point_near(lattice::whole(drawn, grid.origin), steps),
                  direction);
}

/// A part of `size` that is 1 to 2^-2.5digits, or nothing an eighth of the time; of either sign.
[[nodiscard]] inline Whole some_part(Random& random, const Whole& size, const Grid& grid) {
  if (random.one_in(8)) return 0;
  const int bits = static_cast<int>(msb(size)) - static_cast<int>(random.uniform(0, 2.5) * grid.digits);
  const Whole some = lattice::some_whole(random, bits);
  return random.one_in(2) ? -some : some;
}

/// A ray that runs along the plane but for next to nothing, an eighth of the time exactly, and begins so near
/// it that it meets it near `target`, or beside it.
[[nodiscard]] inline std::optional<Scene> to_meet(Random& random, const Grid& grid, const Shape& shape,
                                                  const WholePlane& plane, const glm::dvec3& target) {
  const lattice::PlaneLattice points(plane.n);
  const Whole size = abs(plane.n[0]) + abs(plane.n[1]) + abs(plane.n[2]);
  const glm::dvec3 normal = lattice::vector(plane.n, static_cast<int>(msb(size)));
  const Whole r = random.one_in(8) ? Whole(0) : next_to_nothing(random, size << grid.digits, grid);
  const WholeVector direction = points.point_near(
      lattice::whole(draw::perpendicular(random, glm::normalize(normal)), grid.direction), r);
  if (lattice::dot(direction, direction) == 0) return std::nullopt;
  const int t = random.one_in(2) ? 0 : random.between(1, 7);
  const Whole off = random.one_in(2) ? Whole(0) : some_part(random, size << grid.digits, grid);
  const Whole steps =
      (plane.height << (grid.origin - grid.shape)) - t * (r << (grid.origin - grid.direction)) + off;
  const glm::dvec3 drawn = target - double{1} * t * lattice::vector(direction, grid.direction);
  return scene_of(grid, shape, points.point_near(lattice::whole(drawn, grid.origin), steps), direction);
}

/// A ray that begins beside corner + u·a + v·b and meets it there: v is beside the middle of two numbers, or
/// beside the number at which the interval of t ends, which is none of its business; u has few digits. All
/// three are multiples of 2^-bits_of_edges, and a, b the edges of a figure.
[[nodiscard]] inline std::optional<Scene> to_round_a_coordinate(Random& random, Precision precision,
                                                                const Shape& shape, const glm::dvec3& corner,
                                                                const glm::dvec3& a, const glm::dvec3& b) {
  constexpr int bits_of_edges = 16;
  const bool is_tiny = corner == glm::dvec3(0) && random.one_in(2), ends_there = random.one_in(4);
  const int digits = draw::digits_of(precision), bits = 6 * digits;
  const int e = random.between(1, is_tiny ? 2 * digits : 3);
  const double u = is_tiny ? 0 : random.between(0, 8) / 16.0;
  const Whole M = 2 * lattice::some_whole(random, digits) + (ends_there ? 0 : 1);
  Whole v = M << (bits - digits - 1 - e);
  if (!random.one_in(4)) {
    const Whole off =
        lattice::some_whole(random, bits - e - static_cast<int>(random.uniform(1.5, 2.5) * digits));
    v += random.one_in(2) ? -off : off;
  }
  Scene scene{{}, {}, shape};
  for (int i = 0; i < 3; ++i) {
    const Whole place = lattice::whole(corner[i] + u * a[i], bits) +
                        ((v * lattice::whole(b[i], bits_of_edges)) >> bits_of_edges);
    const double high = lattice::difference(precision, place, bits).high;
    const double size = is_tiny ? std::abs(high) : std::max(std::abs(high), 0.25);
    const double step = size == 0 ? 0 : std::ldexp(1.0, 1 + std::ilogb(size) - digits);
    scene.origin[i] = round_to(precision, high + random.between(-2, 2) * step);
    const Whole way = place - lattice::whole(scene.origin[i], bits);
    scene.direction[i] = round_to(precision, lattice::number(way, bits - digits));
  }
  if (scene.direction == glm::dvec3(0)) return std::nullopt;
  if (ends_there) scene.t_max = lattice::number(M, digits + 1 + e);
  return scene;
}

/// A map of halves of small whole numbers, which rounds nothing on the grid of shapes; most often the
/// identity. What is hard for the mapped figure in the world is as hard for the figure under the map.
struct ShortMap {
  glm::dmat3 linear{1};
  glm::dvec3 by{};

  [[nodiscard]] static ShortMap some(Random& random) {
    ShortMap map;
    if (!random.one_in(3)) return map;
    do {
      map.linear = {0.5 * whole_point(random, 3), 0.5 * whole_point(random, 3), 0.5 * whole_point(random, 3)};
    } while (glm::determinant(map.linear) == 0);
    map.by = whole_point(random, 4);
    return map;
  }
  /// The same, and half the time stretched along the figure's axes by powers of two, for whole figures.
  [[nodiscard]] static ShortMap uneven(Random& random) {
    ShortMap map = some(random);
    if (random.one_in(2)) return map;
    for (int axis = 0; axis < 3; ++axis) map.linear[axis] *= std::exp2(random.between(-10, 4));
    return map;
  }
  [[nodiscard]] glm::dvec3 point(const glm::dvec3& p) const { return linear * p + by; }
  [[nodiscard]] glm::dvec3 vector(const glm::dvec3& v) const { return linear * v; }
  /// The scene, whose shape is not mapped yet, under this map.
  [[nodiscard]] std::optional<Scene> put(std::optional<Scene> scene) const {
    if (!scene || linear == glm::dmat3(1)) return scene;
    glm::dmat4 whole(linear);
    whole[3] = glm::dvec4(by, 1);
    scene->transform = whole;
    return scene;
  }
};
/// The grid of a figure whose mapped numbers lie on the grid of shapes.
[[nodiscard]] inline int before_the_map(const Grid& grid) { return grid.shape - 1; }

/// The first scene that `draw(grid)` gives.
[[nodiscard]] Scene first_drawn(Precision precision, auto&& draw) {
  for (;;)
    if (const std::optional<Scene> scene = draw(grid_of(precision))) return *scene;
}

}  // namespace rayproof::hard
