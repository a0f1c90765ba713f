#pragma once
/// \file
/// The parallelepiped, and the meaning of a ray/parallelepiped method's answers.

#include <array>
#include <rayproof/method/contract.hpp>
#include <rayproof/roots.hpp>

namespace rayproof {

/// The closed solid of all corner + r·edges[0] + s·edges[1] + t·edges[2] with r, s, t in [0, 1]. The edges
/// are independent. Its answer is the interval of t inside it, as `chord` has it.
///
/// Units of the contracts. Face pair i has the normal nᵢ = eⱼ×eₖ of size Nᵢ = |eⱼ||eₖ|; S = |origin - corner|
/// + |e₀| + |e₁| + |e₂| and L(t) = S + |t||direction|. *Residual* is the distance of p(t) from the nearest
/// face plane: |nᵢ·(p(t) - point of the plane)| / (ε·Nᵢ·L(t)). *Verdict* is the least distance of the ray
/// from an edge of its outline (between a face that it enters by and one that it leaves by), or of an end of
/// its interval from the surface, in units of ε·L(t) where it is nearest; of a bound with a `far_power` p in
/// units of ε·L(t)/v^p, where v is the volume with edges of length 1, small for edges that nearly lie in a
/// plane. *Ulp* is in ulps of the exact t. *Domain* speaks of all numbers of the case that are not 0.
template <class T>
struct Parallelepiped {
  vec3<T> corner;
  std::array<vec3<T>, 3> edges;
};

/// The same solid in another arithmetic.
template <class To, class From>
[[nodiscard]] constexpr Parallelepiped<To> convert(const Parallelepiped<From>& p) {
  return {convert<To>(p.corner), {convert<To>(p.edges[0]), convert<To>(p.edges[1]), convert<To>(p.edges[2])}};
}

/// The bound, in the units above, that a robust method keeps (Claim::robust).
inline constexpr double parallelepiped_robust_bound = 8;

/// Why the methods that round the normals do not keep it.
inline constexpr const char* parallelepiped_normals_turn =
    "rounding turns the normals of edges that nearly lie in one plane";

/// What every sound method says of its first hit. K = Nᵢ/|nᵢ|. A face is near p(t) as for *residual*.
inline constexpr HitBounds parallelepiped_hit_bounds{
    .point = {.measured = 1.2, .promised = 2, .is_proven = true},
    .normal = {.measured = 2.48, .promised = 5}};

}  // namespace rayproof
