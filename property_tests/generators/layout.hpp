#pragma once
/// \file
/// Families made of a layout: a function of `(Random&)`, or `(Random&, Precision)`, that puts a ray and a
/// shape together. The same layout can be asked as it is, cut short, moved by a map, or in another size.

#include <glm/matrix.hpp>

#include "case/each_number.hpp"
#include "generators/aim.hpp"
#include "generators/generators.hpp"

namespace rayproof {

/// The question of a layout's scene, once `change(random, precision, scene)` has worked on it.
template <auto layout, auto change>
[[nodiscard]] Question ask(Random& random, Precision precision) {
  return first_accepted([&] {
    Scene scene;
    if constexpr (std::is_invocable_v<decltype(layout), Random&, Precision>)
      scene = layout(random, precision);
    else
      scene = layout(random);
    change(random, precision, scene);
    return question(precision, scene);
  });
}

inline void leave(Random& /*random*/, Precision /*precision*/, const Scene& /*scene*/) {}

template <auto layout>
[[nodiscard]] Family laid_out(const char* name, const char* description, std::vector<MinimumShare> shares) {
  return {name, description, ask<layout, leave>, std::move(shares)};
}

/// The same of a layout that is hard alone for methods that have more digits than the format.
template <auto layout, auto change = leave>
[[nodiscard]] Family beyond_the_digits(const char* name, const char* description,
                                       std::vector<MinimumShare> shares) {
  Family family{name, description, ask<layout, change>, std::move(shares)};
  family.is_beyond_the_digits = true;
  return family;
}

/// Ends the interval of a ray that is aimed at the surface there, or a few ulps beside.
inline void cut(Random& random, Precision precision, Scene& scene) {
  const int kind = random.between(0, 4);
  if (kind == 0 && scene.aimed_at != 0) {  // The segment [0, 1] from the origin to the hit.
    scene.direction = scene.aimed_at * scene.direction;
    scene.t_min = 0;
    scene.t_max = 1;
    return;
  }
  const double t0 = at_or_beside(random, precision, scene.aimed_at);
  const double t1 = at_or_beside(random, precision, scene.aimed_at);
  scene.t_min = kind == 1 ? -std::numeric_limits<double>::infinity() : kind == 2 ? std::min(0.0, t0) : t0;
  scene.t_max = kind == 3 ? std::numeric_limits<double>::infinity() : kind == 4 ? t1 : t0;
  if (scene.t_max < scene.t_min) std::swap(scene.t_min, scene.t_max);
}

/// The layout, which aims at the surface, cut there.
template <auto layout>
[[nodiscard]] Family cut_short(std::vector<MinimumShare> shares) {
  return {"interval", "t_min or t_max at a hit or a few ulps beside it; segments", ask<layout, cut>,
          std::move(shares)};
}

/// A rotation: three unit vectors at right angles.
[[nodiscard]] inline glm::dmat3 rotation(Random& random) {
  const glm::dvec3 x = draw::unit_vector(random);
  const glm::dvec3 y = draw::perpendicular(random, x);
  return {x, y, glm::cross(x, y)};
}

/// A stretch by factors of which the greatest is `condition` times the least; mirrored half the time.
[[nodiscard]] inline glm::dmat3 stretch(Random& random, double condition) {
  const double middle = std::exp(random.uniform(0, std::log(condition)));
  const double mirror = random.one_in(2) ? -1 : 1;
  const double size = std::exp2(random.uniform(-2, 2)) / std::sqrt(condition);
  return {glm::dvec3(mirror * size, 0, 0), glm::dvec3(0, middle * size, 0),
          glm::dvec3(0, 0, condition * size)};
}

/// The identity, a rotation, a shear, a stretch, or all of them.
[[nodiscard]] inline glm::dmat3 linear_part(Random& random) {
  const int kind = random.between(0, 4);
  if (kind == 0) return glm::dmat3(1);
  if (kind == 1) return rotation(random);
  if (kind == 2) {
    glm::dmat3 shear(1);
    shear[random.between(1, 2)][0] = random.uniform(-10, 10);
    return shear;
  }
  if (kind == 3) return stretch(random, std::pow(10, random.uniform(0, 2)));
  const glm::dmat3 first = rotation(random);
  const glm::dmat3 second = stretch(random, std::pow(10, random.uniform(0, 6)));
  return rotation(random) * second * first;
}

/// Moves a scene that was laid out in the shape's own space into the world: the ray goes along, t stays.
inline void move_by(Scene& scene, const glm::dmat3& linear, const glm::dvec3& moved_by) {
  scene.origin = linear * scene.origin + moved_by;
  scene.direction = linear * scene.direction;
  glm::dmat4 whole(linear);
  whole[3] = glm::dvec4(moved_by, 1);
  scene.transform = whole;
}

/// The same by any map.
inline void move_into_the_world(Random& random, Precision /*precision*/, Scene& scene) {
  const glm::dmat3 linear = linear_part(random);
  move_by(scene, linear, point_in_a_room(random));
}

/// The same by a stretch along any axes, and the point that was aimed at is looked at from any side of the
/// world: what is stretched is mostly seen from across.
inline void move_and_look_again(Random& random, Precision /*precision*/, Scene& scene) {
  const glm::dmat3 first = rotation(random);
  const glm::dmat3 second = stretch(random, std::pow(10, random.uniform(0.5, 2.5)));
  const glm::dmat3 linear = rotation(random) * second * first;
  move_by(scene, linear, point_in_a_room(random));
  const glm::dvec3 target = scene.origin + scene.aimed_at * scene.direction;
  scene.direction = draw::unit_vector(random);
  scene.origin = target - scene.aimed_at * scene.direction;
}

/// The same by a map of small whole numbers, which rounds nothing in a scene of short numbers.
inline void move_exactly(Random& random, Precision /*precision*/, Scene& scene) {
  const auto whole = [&] { return whole_point(random, 2); };
  glm::dmat3 linear(0);
  while (glm::determinant(linear) == 0) linear = {whole(), whole(), whole()};
  move_by(scene, linear, whole());
}

/// By a stretch along the axes by powers of two, a quarter of the time: every number stays as hard as it was.
inline void maybe_stretch(Random& random, Precision /*precision*/, Scene& scene) {
  if (!random.one_in(4)) return;
  glm::dmat3 linear(0);
  for (int axis = 0; axis < 3; ++axis)
    linear[axis][axis] = std::ldexp(random.one_in(2) ? 1 : -1, random.between(-4, 4));
  move_by(scene, linear, glm::dvec3(0));
}

/// The layout under an affine map; a third of the time one of whole numbers under a whole map, where there is
/// such a layout, so that the world's ray, too, passes exactly where it was aimed.
template <auto layout, auto whole = nullptr>
[[nodiscard]] Family transformed(std::vector<MinimumShare> shares) {
  const auto ask_moved = [](Random& random, Precision precision) {
    if constexpr (!std::is_null_pointer_v<decltype(whole)>)
      if (random.one_in(3)) return ask<whole, move_exactly>(random, precision);
    return ask<layout, move_into_the_world>(random, precision);
  };
  return {"transformed", "an affine map of condition 1 to 1e6: moved, mirrored, sheared, stretched",
          ask_moved, std::move(shares)};
}

/// An interval that ends well before or beyond the point that is aimed at, and a map of any size from 10^-3
/// to 10^3: who takes t for a distance in the object's space, or a small determinant for 0, is wrong.
inline void cut_and_place(Random& random, Precision precision, Scene& scene) {
  const double near = scene.aimed_at * random.uniform(0.1, 0.9),
               far = scene.aimed_at * random.uniform(1.1, 9);
  const int kind = random.between(0, 3);
  if (kind == 0) scene.t_max = near;
  if (kind == 1) scene.t_min = far;
  if (kind == 2) scene.t_min = near;
  if (kind >= 2) scene.t_max = far;
  if (scene.t_max < scene.t_min) std::swap(scene.t_min, scene.t_max);
  scene.t_min = round_to(precision, scene.t_min);
  scene.t_max = round_to(precision, scene.t_max);
  const double size = std::pow(10, random.uniform(-3, 3));
  move_by(scene, size * linear_part(random), size * point_in_a_room(random));
}

/// The layout so.
template <auto layout>
[[nodiscard]] Family placed(std::vector<MinimumShare> shares) {
  return {"placed", "a map of size 1e-3 to 1e3; t_min and t_max before the hit or beyond",
          ask<layout, cut_and_place>, std::move(shares)};
}

/// Makes a scene, whose numbers are between 2^-8 and 2^8, as large or small as the format has numbers.
inline void resize(Random& random, Precision precision, Scene& scene) {
  const double size = std::exp2(draw::any_exponent(random, precision, 10));
  scene.origin *= size;
  scene.direction *= std::exp2(draw::any_exponent(random, precision, 10));
  std::visit([size](auto& shape) { shape = grown(shape, size); }, scene.shape);
}

/// Makes it 2^-16 to 2^-3 times as large, half the time with as short a direction: an epsilon that has
/// nothing to do with the scene's size is larger than that.
inline void shrink(Random& random, Precision /*precision*/, Scene& scene) {
  const double size = std::exp2(random.between(-16, -3));
  scene.origin *= size;
  scene.direction *= random.one_in(2) ? size : 1;
  std::visit([size](auto& shape) { shape = grown(shape, size); }, scene.shape);
}

template <auto layout>
[[nodiscard]] Family in_small(std::vector<MinimumShare> shares) {
  return {"small", "2^-16 to 2^-3 times as large as others, half the time with as short a direction",
          ask<layout, shrink>, std::move(shares)};
}

/// Makes it nearly as small as the contracts go (2^-28, of doubles 2^-240), half the time with as short a
/// direction: products of two of its lengths are numbers still, and the squares of those are none.
inline void make_the_smallest(Random& random, Precision precision, Scene& scene) {
  const double size = std::exp2(random.between(-1, 4) - (precision == Precision::float32 ? 28 : 240));
  scene.origin *= size;
  scene.direction *= random.one_in(2) ? size : 1;
  std::visit([size](auto& shape) { shape = grown(shape, size); }, scene.shape);
}

/// A slender layout of that size.
template <auto layout>
[[nodiscard]] Family of_the_smallest_size(std::vector<MinimumShare> shares) {
  Family family{"smallest", "slender, and as small as the contracts go: the squares of normals underflow",
                ask<layout, make_the_smallest>, std::move(shares)};
  family.is_beyond_the_digits = true;
  return family;
}

/// Moves what the ray is aimed at to (0, 0, 0), and the ray to where it passes exactly through that point,
/// from so far away that more than the format's digits cancel.
inline void see_from_the_horizon(Random& random, Precision precision, Scene& scene) {
  move(scene.shape, -(scene.origin + scene.aimed_at * scene.direction));
  scene.direction = toward_the_horizon(random);
  scene.origin = horizon(random, precision, scene.direction);
}

/// Puts the ray 2^(0.6·digits) to 2^(0.98·digits) before what it is aimed at.
inline void see_from_far_off(Random& random, Precision precision, Scene& scene) {
  const glm::dvec3 target = scene.origin + scene.aimed_at * scene.direction;
  const double distance = std::exp2(random.uniform(0.6, 0.98) * draw::digits_of(precision));
  scene.origin = target - distance * scene.direction;
}

/// Half the time a layout that is aimed at the boundary, else one that is aimed at the inside.
template <auto at_the_boundary, auto inside>
[[nodiscard]] Family from_the_horizon(std::vector<MinimumShare> shares) {
  const auto ask_either = [](Random& random, Precision precision) {
    return random.one_in(2) ? ask<at_the_boundary, see_from_the_horizon>(random, precision)
                            : ask<inside, see_from_far_off>(random, precision);
  };
  Family family{"horizon", horizon_description, ask_either, std::move(shares)};
  family.is_beyond_the_digits = true;
  return family;
}

template <auto layout>
[[nodiscard]] Family in_any_size(std::vector<MinimumShare> shares) {
  return {"exponents", "scenes of one size, of any exponent the format has", ask<layout, resize>,
          std::move(shares)};
}

}  // namespace rayproof
