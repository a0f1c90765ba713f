#pragma once
#include <rayproof/method/method.hpp>
#include <rayproof/parametric/bezier.hpp>
#include <rayproof/quadratic/kahan.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::parametric {

/// A hit of the closed form: NaN where there is none.
template <class T>
struct BilinearHit {
  T t, u, v;
};

/// The bilinear patch in closed form: the line through the two points that u marks on the edges v = 0 and
/// v = 1 meets the ray where their volume with the direction is 0, a quadratic in u.
///
/// Plain and fast; no contract but what `parametric::hits` on the same patch says of it. Where the ray lies
/// in a ruling, or the volume is 0 for every u, it has no answer.
struct BilinearQuadratic {
  static constexpr const char* name = "bilinear_quadratic";
  static constexpr Source source{"A. Reshetov",
                                 "Cool Patches: A Geometric Approach to Ray/Bilinear Patch Intersections, "
                                 "Ray Tracing Gems ch. 8",
                                 2019};

  /// Both solutions, by ascending u, each with u and v in [0, 1] and t in the ray's interval or NaN.
  template <class T>
  [[nodiscard]] static std::array<BilinearHit<T>, 2> roots(const Ray<T>& ray, const BilinearPatch<T>& patch) {
    step<T>("Move the ray's origin to the origin",
            "p is the corner r(0, 0) seen from the ray's origin, p_u and e lead to the next corners along u "
            "and v, and e_u is what e gains along u.");
    const vec3<T> d = ray.direction;
    const vec3<T> a = named("p", patch.points[0][0] - ray.origin);
    const vec3<T> a_u = named("p_u", patch.points[1][0] - patch.points[0][0]);
    const vec3<T> e = named("e", patch.points[0][1] - patch.points[0][0]);
    const vec3<T> e_u = named("e_u", (patch.points[1][1] - patch.points[1][0]) - e);

    step<T>("Let the volume of direction, edge point and ruling be 0",
            "For each u the patch has a straight line, its ruling; it meets the ray where both lie in one "
            "plane, a quadratic equation in u.");
    const vec3<T> f = named("f", cross(a, d)), f_u = named("f_u", cross(a_u, d));
    const Quadratic<T> volume{named("a", dot(f_u, e_u)), named("b", dot(f, e_u) + dot(f_u, e)),
                              named("c", dot(f, e))};
    const Roots<T> u = quadratic::Kahan::roots(volume);
    return {on_ruling<T>(ray, a + u.lo * a_u, e + u.lo * e_u, u.lo),
            on_ruling<T>(ray, a + u.hi * a_u, e + u.hi * e_u, u.hi)};
  }

 private:
  /// Where the ray meets the line p + v·e.
  template <class T>
  static BilinearHit<T> on_ruling(const Ray<T>& ray, const vec3<T>& at_0, const vec3<T>& along, const T& u) {
    step<T>("Meet the ruling in the plane that it and the ray span",
            "The two lines meet where p(u) + v·e(u) = t·d; products with their normal n = d × e(u) give t "
            "and v.");
    const vec3<T> p = named("p(u)", at_0);
    const vec3<T> e = named("e(u)", along);
    const vec3<T> n = named("n", cross(ray.direction, e));
    step<T>("Divide by the square of the normal",
            "p(u) × e(u) along n is t times n·n, and p(u) × d along n is v times n·n. Where u or v is not in "
            "[0, 1], the lines meet off the patch.");
    const T nn = dot(n, n);
    const vec3<T> g = named("g", cross(p, e)), h = named("h", cross(p, ray.direction));
    const T t = named("t", dot(g, n) / nn);
    const T v = named("v", dot(h, n) / nn);
    const Mask<T> is_hit = T(0) <= u && u <= T(1) && T(0) <= v && v <= T(1) && in_interval(ray, t);
    const T none = not_a_number<T>;
    return {select(is_hit, t, none), select(is_hit, u, none), select(is_hit, v, none)};
  }
};

}  // namespace rayproof::parametric

#include <rayproof/rounding/as_before.hpp>
