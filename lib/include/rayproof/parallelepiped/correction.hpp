#pragma once
#include <rayproof/box/nearest_end.hpp>
#include <rayproof/formulas/corrected_flat_hit.hpp>
#include <rayproof/parallelepiped/prepared.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::parallelepiped {

/// A solid before it meets a ray, and the largest sizes of a normal's component and of what it makes of the
/// edge that leads from face to face.
template <class W>
struct SizedFaces {
  Prepared<W> faces;
  double size_of_n = 0, size_of_apart = 0;
};
template <class To, class From>
[[nodiscard]] constexpr SizedFaces<To> convert(const SizedFaces<From>& solid) {
  return {convert<To>(solid.faces), solid.size_of_n, solid.size_of_apart};
}

/// The nearest hit of three pairs of parallel planes, corrected: with the plane of the face that is met.
struct Correction {
  template <class W>
  [[nodiscard]] static constexpr SizedFaces<W> prepared(const Parallelepiped<W>& solid) {
    SizedFaces<W> sized{prepared_faces(solid)};
    for (const FacePair<W>& pair : sized.faces.pairs) {
      sized.size_of_n = max(sized.size_of_n, largest_size(pair.normal));
      sized.size_of_apart = max(sized.size_of_apart, pair.apart.size);
    }
    return sized;
  }

  /// With u the unit roundoff a normal is off by 2u of its size, f = corner - o by u, so that n·d is off by
  /// 5u times the sizes of its terms, n·f by 6u, n·e by 5u and their sum by 7u of both. Where n·d is clear of
  /// 0, an end, what is ahead times 1/(n·d), is off by 7u times the size of what is ahead and 7u |t| times
  /// that of n·d, over n·d. A ray along a face is in doubt, and a solid whose edges nearly lie in one plane.
  template <class N>
  [[nodiscard]] static constexpr CorrectionStart<N> start(const Ray<N>& ray, const Parallelepiped<N>& solid) {
    const auto& e = solid.edges;
    const vec3<N> f = solid.corner - ray.origin, d = ray.direction;
    const auto size_of = [](const vec3<N>& v) { return sum_of_magnitudes<N>(v) + N(least_length<N>); };
    const N size_of_f = size_of(f), size_of_d = size_of(d);
    const N bound(10 * unit_roundoff<N>), most(1 / least_error<N>), clear(0x1p10 * unit_roundoff<N>);
    const auto directed = [&](std::size_t i, std::size_t j, std::size_t k) -> box::DirectedSlab<N> {
      const vec3<N> n = cross(e[j], e[k]);
      const N apart = dot(n, e[i]), size_of_n = size_of(e[j]) * size_of(e[k]);
      const N size_of_apart = size_of_n * size_of(e[i]);
      const Mask<N> is_solid = clear * size_of_apart < abs(apart) && size_of_n < most;

      const N speed = dot(n, d), size_of_speed = size_of_n * size_of_d, per_speed = N(1) / speed;
      const Mask<N> is_clear = clear * size_of_speed < abs(speed) && is_solid && size_of_d < most;
      const N near_plane = dot(n, f), t_near = near_plane * per_speed,
              t_far = (near_plane + apart) * per_speed;

      const N scale = bound * abs(per_speed), size_of_far = size_of_n * size_of_f + size_of_apart;
      const N ahead = select(is_clear, size_of_far * scale + N(least_error<N>), N(infinity<N>));
      const N entry = min(t_near, t_far), exit = max(t_near, t_far), per_t = size_of_speed * scale;
      return {entry, exit, ahead + abs(entry) * per_t, ahead + abs(exit) * per_t, t_far < t_near};
    };
    return box::nearest_end(ray, directed(0, 1, 2), directed(1, 2, 0), directed(2, 0, 1));
  }

  /// f(t) = n·(o - corner + t·d), less n·e for the second face of a pair.
  template <class N, class W>
  [[nodiscard]] static constexpr Linear<N> residual(const Ray<N>& /*ray*/, const Ray<W>& wide,
                                                    const CorrectionStart<N>& /*narrow*/,
                                                    const CorrectionStart<W>& start,
                                                    const SizedFaces<W>& solid) {
    const auto& pairs = solid.faces.pairs;
    const auto which = abs(start.face);
    const auto is_first = which < W(1.5), is_third = W(2.5) < which;
    const auto of_pair = [&](const auto& member) {
      return select(is_first, member(pairs[0]), select(is_third, member(pairs[2]), member(pairs[1])));
    };
    const vec3<W> n{of_pair([](const auto& pair) { return pair.normal.x.value; }),
                    of_pair([](const auto& pair) { return pair.normal.y.value; }),
                    of_pair([](const auto& pair) { return pair.normal.z.value; })};
    const W apart = of_pair([](const auto& pair) { return pair.apart.value; });
    const vec3<W> w = wide.origin - solid.faces.corner, d = wide.direction;
    const vec3<W> q = multiply_add(start.t, d, w);
    return {narrow(dot(n, q) - select(start.face < W(0), apart, W(0))), narrow(dot(n, d))};
  }

  template <class N, class W>
  [[nodiscard]] static constexpr Corrected<N> nearest(const Ray<N>& ray, const CorrectionStart<N>& start,
                                                      const Linear<N>& f, const SizedFaces<W>& solid) {
    return nearest_root(
        ray, corrected_flat_hit<W>(ray, start.t, f, N(solid.size_of_n),
                                   narrowed_vector<N>(solid.faces.corner), N(solid.size_of_apart)));
  }
};

}  // namespace rayproof::parallelepiped

#include <rayproof/rounding/as_before.hpp>
