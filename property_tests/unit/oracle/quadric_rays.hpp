#pragma once
/// \file
/// Rays and quadrics to try enclosures on, each family aimed at one difficulty. Every number is exact in `T`.

#include <rayproof/implicit/quadric.hpp>
#include <rayproof/ray.hpp>
#include <string_view>

#include "generators/draw.hpp"

namespace rayproof::oracle::test {

template <class T>
struct QuadricScene {
  Ray<T> ray;
  implicit::Quadric<T> quadric;
};

/// A quadric of ten numbers from one draw.
template <class T, class Draw>
[[nodiscard]] implicit::Quadric<T> quadric_of(Draw&& draw) {
  implicit::Quadric<T> q{};
  for (T* const coefficient : {&q.xx, &q.yy, &q.zz, &q.yz, &q.xz, &q.xy, &q.xw, &q.yw, &q.zw, &q.ww})
    *coefficient = draw();
  return q;
}

/// A half-line, a line, or a segment that may end on a root at a whole t.
template <class T>
void cut(Random& random, Ray<T>& ray) {
  const int choice = random.between(0, 3);
  if (choice == 1 || choice == 2) ray.t_min = choice == 1 ? -infinity<T> : T(random.between(-9, 9));
  if (choice >= 2) ray.t_max = max(T(random.between(-9, 9)), ray.t_min);
}

/// Numbers in [-1, 1]: crossings, mostly.
template <class T>
[[nodiscard]] QuadricScene<T> uniform_scene(Random& random) {
  const auto number = [&] { return draw::symmetric<T>(random); };
  QuadricScene<T> scene{{draw::vector(number), draw::vector(number)}, quadric_of<T>(number)};
  cut(random, scene.ray);
  return scene;
}

/// Small whole numbers: exact tangents, lines in the surface, asymptotes, roots on the interval's ends.
template <class T>
[[nodiscard]] QuadricScene<T> whole_scene(Random& random) {
  const auto number = [&] { return T(random.between(-4, 4)); };
  const int rare = random.between(1, 4);  // few terms: cylinders, cones, planes, nothing
  const auto coefficient = [&] { return random.between(1, 4) <= rare ? T(random.between(-2, 2)) : T(0); };
  QuadricScene<T> scene{{draw::vector(number), draw::vector(number)}, quadric_of<T>(coefficient)};
  if (scene.ray.direction == vec3<T>(0)) scene.ray.direction.x = 1;
  cut(random, scene.ray);
  return scene;
}

/// A ray that touches a quadric of whole numbers exactly: the surface is put through a point, and the
/// direction at right angles to its gradient there. The nearness is then spoilt by `nudge`.
template <class T>
[[nodiscard]] QuadricScene<T> tangent_scene(Random& random) {
  const auto number = [&] { return random.between(-6, 6); };
  const auto q = quadric_of<int>(number);
  const glm::ivec3 p{number(), number(), number()};
  const int at_p = q.xx * p.x * p.x + q.yy * p.y * p.y + q.zz * p.z * p.z + q.yz * p.y * p.z +
                   q.xz * p.x * p.z + q.xy * p.x * p.y + q.xw * p.x + q.yw * p.y + q.zw * p.z;
  const glm::ivec3 gradient{2 * q.xx * p.x + q.xz * p.z + q.xy * p.y + q.xw,
                            2 * q.yy * p.y + q.yz * p.z + q.xy * p.x + q.yw,
                            2 * q.zz * p.z + q.yz * p.y + q.xz * p.x + q.zw};
  const glm::ivec3 any{number(), number(), number()};
  const glm::ivec3 d{gradient.y * any.z - gradient.z * any.y, gradient.z * any.x - gradient.x * any.z,
                     gradient.x * any.y - gradient.y * any.x};
  const int back = random.between(-3, 5);
  const auto as = [](int x) { return static_cast<T>(x); };
  QuadricScene<T> scene{
      {{as(p.x - back * d.x), as(p.y - back * d.y), as(p.z - back * d.z)}, {as(d.x), as(d.y), as(d.z)}},
      {as(q.xx), as(q.yy), as(q.zz), as(q.yz), as(q.xz), as(q.xy), as(q.xw), as(q.yw), as(q.zw), as(-at_p)}};
  if (scene.ray.direction == vec3<T>(0)) scene.ray.direction.z = 1;
  cut(random, scene.ray);
  return scene;
}

/// A tangent moved off by a little: two roots close together, or none but nearly.
template <class T>
[[nodiscard]] QuadricScene<T> near_tangent_scene(Random& random) {
  QuadricScene<T> scene = tangent_scene<T>(random);
  const int digits = std::numeric_limits<T>::digits;
  const T off = draw::magnitude<T>(random, -digits - 4, -3);
  const int which = random.between(0, 3);
  if (which == 3) {
    scene.quadric.ww += off * max(T(1), abs(scene.quadric.ww));
  } else {
    T& moved = scene.ray.origin[which];
    moved += off * max(T(1), abs(moved));
  }
  return scene;
}

/// From far away, or with a very long or short direction, towards a surface of ordinary size.
template <class T>
[[nodiscard]] QuadricScene<T> far_scene(Random& random) {
  QuadricScene<T> scene = uniform_scene<T>(random);
  const T away = draw::magnitude<T>(random, 0, sizeof(T) == 4 ? 16 : 40);
  const T length = draw::magnitude<T>(random, -30, 30);
  const vec3<T> aim = scene.ray.origin;
  scene.ray = {aim - away * scene.ray.direction, length * scene.ray.direction};
  if (random.one_in(4)) scene.ray.t_min = -infinity<T>;
  return scene;
}

/// Sizes all over the range in which nothing overflows.
template <class T>
[[nodiscard]] QuadricScene<T> any_size_scene(Random& random) {
  const double reach = sizeof(T) == 4 ? 20 : 150;
  const auto number = [&] { return draw::magnitude<T>(random, -reach, reach); };
  QuadricScene<T> scene{{draw::vector(number), draw::vector(number)}, quadric_of<T>(number)};
  if (random.one_in(2)) scene.ray.t_min = -infinity<T>;
  return scene;
}

/// Every bit pattern, and the numbers that have broken somebody's code: nothing is promised but no miss.
template <class T>
[[nodiscard]] QuadricScene<T> wild_scene(Random& random) {
  const auto number = [&] {
    return random.one_in(2) ? draw::special<T>(random) : draw::bit_pattern<T>(random);
  };
  QuadricScene<T> scene{{draw::vector(number), draw::vector(number)}, quadric_of<T>(number)};
  if (scene.ray.direction == vec3<T>(0)) scene.ray.direction.y = std::numeric_limits<T>::denorm_min();
  cut(random, scene.ray);
  return scene;
}

template <class T>
struct QuadricFamily {
  std::string_view name;
  QuadricScene<T> (*draw)(Random&);
};
template <class T>
inline constexpr std::array<QuadricFamily<T>, 7> quadric_families{{{"uniform", uniform_scene<T>},
                                                                   {"whole", whole_scene<T>},
                                                                   {"tangent", tangent_scene<T>},
                                                                   {"near tangent", near_tangent_scene<T>},
                                                                   {"far", far_scene<T>},
                                                                   {"any size", any_size_scene<T>},
                                                                   {"wild", wild_scene<T>}}};

}  // namespace rayproof::oracle::test
