#pragma once
#include <rayproof/box/slabs_inverse.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::box {

/// Slabs whose far end is moved two ulps on before it is compared with the near one, so that rounding does
/// not part a ray from a box that it touches.
///
/// What a traversal of a tree of boxes wants, since there a box too many costs time and a box too few a hole.
/// As an answer about the box it is wrong on purpose: it takes a ray that passes an edge within a few ulps
/// for a hit, and every exit for later than it is, even past the end of the ray's interval. The roundings of
/// two t may add up to 6ε and the two ulps are 4ε, so the proof has a gap; a search among millions of rays
/// aimed at edges found no box lost in it.
struct Padded {
  static constexpr const char* name = "padded";
  static constexpr const char* title = "slabs with the far end moved two ulps on";
  static constexpr Source source{"T. Ize", "Robust BVH Ray Traversal", 2013};
  static constexpr Contract contract{
      .standing = Standing::naive,
      .verdict = {.measured = 3.1, .promised = 2},  // which it breaks on purpose, see below
      .ulp = {.measured = 5.9, .promised = 7},
      .hit = {.normal = box_hit_bounds.normal},  // a touch of the padded box is a crossing
      .domain = {.reach_float = 48, .reach_double = 480, .every_number = true},
      .holds =
          always_claimed | Claims{Claim::normal} | Claims{Claim::ulp, Claim::scaled, Claim::conservative},
      .refuted = {
          {{Claim::verdict, "conservative is not exact: a ray that passes an edge within two ulps is a hit"},
           {Claim::reversed, "only the far end is moved, and reversing the ray makes it the near one"}}}};

  template <class T>
  [[nodiscard]] static constexpr Roots<T> roots(const Ray<T>& ray, const Box<T>& box) {
    const auto [entry, exit] = SlabsInverse::common_interval(ray, box);

    step<T>("Move the far end on by two machine epsilons",
            "Rounding may put the exit before the entry: two machine epsilons more, 2 to 4 ulps, can keep a "
            "ray that touches the box, and can make a hit of a near miss.");
    const T two_ulps = T(2 * std::numeric_limits<Plain<T>>::epsilon());
    const T padded = named("t_padded", exit + two_ulps * abs(exit));
    return chord(entry, padded);
  }
};

}  // namespace rayproof::box

#include <rayproof/rounding/as_before.hpp>
