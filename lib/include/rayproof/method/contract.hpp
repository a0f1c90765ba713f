#pragma once
/// \file
/// What a method promises: data beside the kernel, read by the property tests, the listings and the docs.

#include <array>
#include <cstddef>
#include <limits>
#include <string_view>

namespace rayproof {

/// The claims a method can make; each is one property of the property tests (docs/conventions.md).
enum class Claim : unsigned {
  verdict,    ///< hit or miss (or the kind of roots) is the exact one, outside the promised band
  residual,   ///< every answer satisfies the equation to the promised residual
  ulp,        ///< every answer is within the promised ulps of the exact one
  rounded,    ///< the verdict is the exact one, and every t, u and v the exact one rounded once, ties to even
  robust,     ///< verdict and residual keep the bound that the best plain methods of the shape keep
  ascending,  ///< hits come in ascending order, inside the interval, each once, none NaN
  moved,      ///< t is the same after moving object and ray together by an affine map
  scaled,     ///< scaling by powers of two changes nothing but exponents
  reversed,   ///< reversing the ray mirrors its hits
  batch,      ///< a batch gives bit for bit the scalar answers
  nan,        ///< a NaN anywhere in the input never gives a hit
  bounded,    ///< the running-error arithmetic's bound encloses the exact answer
  contact,    ///< why a ray misses is given rightly: parallel to the surface, inside it, or neither
  point,      ///< the first hit's point is on ray and surface to the promised bounds, and touches as is said
  normal,     ///< the normal of the first hit is the surface's there to the promised bound, its side included
  coordinates,   ///< a triangle's barycentric coordinates, a plane's parameters, are exact to the promised
                 ///< bound
  exact,         ///< where no step is rounded, everything is exactly right, boundaries included
  conservative,  ///< a line that meets the shape is never said to miss it
  answers  ///< every valid case gets an answer in time; asked of programs, since a function always answers
};
inline constexpr std::size_t claim_count = 19;

/// A set of claims.
class Claims {
 public:
  constexpr Claims() = default;
  constexpr Claims(std::initializer_list<Claim> claims) {
    for (const Claim claim : claims) bits_ |= bit(claim);
  }
  [[nodiscard]] constexpr bool contains(Claim claim) const { return (bits_ & bit(claim)) != 0; }
  [[nodiscard]] constexpr Claims operator|(Claims other) const {
    other.bits_ |= bits_;
    return other;
  }

 private:
  static constexpr unsigned bit(Claim claim) { return 1U << static_cast<unsigned>(claim); }
  unsigned bits_ = 0;
};

/// An error bound: the worst error ever found, and the bound that is promised and tested. The unit is the
/// shape's (`sphere.hpp`, `quadratic.hpp` say which). What was found, by random cases (docs/nightly.md) or by
/// guided search (docs/worst-cases.md), is a lower bound of the worst there is, and no proof. A bound that is
/// proven has its derivation, or its source, beside it. Where nothing is promised, `promised` is infinite.
/// The unit of a naive method's bound grows with the ratio by which its arithmetic suffers, to the power
/// `far_power`; the shape says which ratio.
struct Bound {
  double measured = std::numeric_limits<double>::infinity();
  double promised = std::numeric_limits<double>::infinity();
  int far_power = 0;
  bool is_proven = false;
};

/// Bounds on what an answer says of its first hit beside t, the same for all sound methods of a shape, which
/// has them beside its units. With ε the unit roundoff:
/// *point* is the distance of the point from p(t) in units of ε·(|origin| + |t||direction|), so that it is no
/// farther from the surface than the residual and this together (2 is proven: each coordinate is a product
/// and a sum, off by ε·|t·d| and by ε·(|o| + |t·d|) at most, or by less where one is below the other's ulp);
/// *normal* the sine of the angle to the surface's outward (or given) normal at p(t), 1 from a right angle
/// on, which is the least relative change that turns a vector so, in units of ε·K with the condition K that
/// the shape states, and the difference of its length from 1 in units of ε; near an edge it may be that of
/// either face. Without a transform, to make it a unit vector turns it by ε at most, and leaves its length
/// within 4.5ε of 1; *coordinates* the error of each coordinate x in units of ε·K, of a method that promises
/// ulps in units of ε·max(1, |x|). Under a transform K grows by its condition number. The usual domain holds
/// for them, however far a method's own may reach.
struct HitBounds {
  Bound point{};
  Bound normal{};
  Bound coordinates{};
};

/// How far a method is to be trusted.
enum class Standing {
  sound,   ///< keeps its contract wherever its domain reaches
  naive,   ///< the right formula in an arithmetic that can't bear it: `refuted` says where it breaks
  printed  ///< copied from a lecture with the lecture's error: must be refuted
};

/// A claim that the method is known to break, and why. `rayproof check` demands the counterexample.
struct Refutation {
  Claim claim{};
  std::string_view because{};
};

/// The sizes of input for which the bounds hold: every length of the problem (the shape's unit says which)
/// lies within 2^-reach and 2^reach, so that no intermediate of the formula overflows or loses digits to
/// underflow. Of a transform the lengths are its entries and its inverse's norm, and its condition is at most
/// 2^-6/ε unless the method takes the transform itself: beyond, the ray may lose every digit on its way into
/// object space.
struct Domain {
  int reach_float = 28;
  int reach_double = 240;
  int reach_transformed = 24;  ///< of a case with a transform, for a method that takes the transform itself
  bool every_number = false;   ///< the reach is asked of every number that is not 0, not just of the lengths
};
inline constexpr int largest_condition_float = 18, largest_condition_double = 47;  ///< powers of two
inline constexpr Domain any_finite{.reach_float = 1000000, .reach_double = 1000000};

/// The contract of one method.
struct Contract {
  Standing standing = Standing::sound;
  Bound verdict{};   ///< half-width of the band around a change of verdict in which the verdict may be wrong
  Bound residual{};  ///< residual of every answer
  Bound ulp{};       ///< error of every answer in ulps of the exact one
  HitBounds hit{};   ///< errors of the first hit's point, normal and coordinates
  Domain domain{};
  Claims holds{};                       ///< claims the property tests hold the method to
  std::array<Refutation, 3> refuted{};  ///< claims it is known to break; unused entries have no `because`

  /// Whether the claim is made, or declared broken.
  [[nodiscard]] constexpr bool speaks_of(Claim claim) const {
    bool is_refuted = false;
    for (const Refutation& one : refuted) is_refuted |= one.claim == claim && !one.because.empty();
    return is_refuted || holds.contains(claim);
  }
};

/// Author, title and year of the formula's source.
struct Source {
  std::string_view author;
  std::string_view title;
  int year;
};

/// The claims every method makes, however bad its formula.
inline constexpr Claims always_claimed{Claim::ascending, Claim::batch, Claim::nan};

/// The claims of every method that keeps the robust bound, wherever the scene lies and whatever its size.
inline constexpr Claims robust_claims =
    always_claimed |
    Claims{Claim::verdict, Claim::robust, Claim::moved, Claim::scaled, Claim::reversed, Claim::exact};

/// What every method claims of its first hit that keeps its shape's `HitBounds`.
inline constexpr Claims hit_claims{Claim::point, Claim::normal};

}  // namespace rayproof
