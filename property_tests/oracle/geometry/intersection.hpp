#pragma once
/// \file
/// The exact intersection of a ray and a shape, which both answers and judges.

#include <array>
#include <boost/container/static_vector.hpp>
#include <cmath>
#include <variant>

#include "case/answer.hpp"
#include "oracle/geometry/scene.hpp"
#include "oracle/numbers/quotient.hpp"
#include "oracle/numbers/root.hpp"

namespace rayproof::oracle {

/// An exact t, rational or not.
using ExactNumber = std::variant<Quotient, ExactRoot>;

/// Whether an exact t lies in the closed interval from `low` to `high`, which may be infinite.
template <class Number>
[[nodiscard]] bool is_in_interval(const Number& t, double low, double high) {
  using R = typename Number::Over;
  const bool above = std::isinf(low) || t.compare(R(low)) >= 0;
  return above && (std::isinf(high) || t.compare(R(high)) <= 0);
}

/// A hit, and how the ray touches the shape there.
template <class Number>
struct HitAt {
  Number t;
  Contact contact;
};
using ExactContact = HitAt<ExactNumber>;
using ExactContacts = boost::container::static_vector<ExactContact, 2>;  // a convex shape has two at most

/// A normal of any length in the object's space: offset + t·slope, or the same at every t.
struct ExactNormal {
  Vector<Ring> offset;
  std::optional<Vector<Ring>> slope{};
};

/// A part of a shape's surface: a face, a cap, the side.
struct SurfacePart {
  ExactNormal normal;  ///< of its surface through p(t), on the side that the shape names
  Scaled apart{};      ///< how far p(t) is from it
  Scaled condition;    ///< by what factor errors of the shape's numbers and of p(t) may turn that normal
};
using SurfaceParts = boost::container::static_vector<SurfacePart, 6>;  // a solid has six faces

/// What a ray and a shape come to, and how far claims are from it, in the units of the shape's contract but
/// for ε. An answer needs no such measures: what is costly in them waits until one is asked for. The question
/// and its shape outlive the intersection.
class ExactIntersection {
 public:
  explicit ExactIntersection(const RayQuestion& question) : question_(question), ray_(question) {}
  virtual ~ExactIntersection() = default;

  [[nodiscard]] const RayQuestion& question() const { return question_; }
  [[nodiscard]] const ObjectRay<Ring>& ray() const { return ray_; }

  /// The hits in the ray's interval, ascending, each once.
  [[nodiscard]] virtual ExactContacts hits() const = 0;
  /// Why there is none.
  [[nodiscard]] virtual Contact miss() const { return Contact::none; }
  /// The normal at a hit; nothing where it is not unique.
  [[nodiscard]] virtual std::optional<ExactNormal> normal(const ExactContact& hit) const = 0;
  /// [α, β, γ] of a triangle's hit.
  [[nodiscard]] virtual std::optional<std::array<Quotient, 3>> barycentric() const { return std::nullopt; }
  /// [α, β] of a parametric plane's hit, point + α·u + β·v.
  [[nodiscard]] virtual std::optional<std::array<Quotient, 2>> parameters() const { return std::nullopt; }

  /// How far p(t) is from the surface.
  [[nodiscard]] virtual Scaled residual(const Quotient& t) const = 0;
  /// How far a point of the shape's own space, in the scale of ObjectRay, is from the surface, in units of
  /// the lengths that it is made of as p(t), L(t).
  [[nodiscard]] virtual Scaled off_surface(const Vector<Ring>& point, const Quotient& t) const = 0;
  /// The parts of the surface, one of which p(t) is taken to lie on; none where the shape has no normal. The
  /// condition of a curved part may depend on the unit roundoff.
  [[nodiscard]] virtual SurfaceParts parts(const Quotient& t, const Scaled& roundoff) const = 0;
  /// By what factor errors of the shape's numbers and of the ray change the coordinates of a hit; it may
  /// depend on the unit roundoff.
  [[nodiscard]] virtual Scaled condition_of_coordinates(const Scaled& /*roundoff*/) const {
    return Scaled(1);
  }
  /// How near the case is to another verdict: how much its lengths must change. Two hits that `may_merge` are
  /// taken for one where they are near one another.
  [[nodiscard]] virtual Scaled margin(bool may_merge) const = 0;
  /// The ratio by which naive methods degrade.
  [[nodiscard]] virtual double far() const { return 1; }

 protected:
  /// Whether the ray stays beyond something: its finite end at t is its first point and it moves away
  /// (way > 0), or its last and it has been coming nearer (way < 0).
  [[nodiscard]] bool stays_beyond(int way, double t) const {
    return (way > 0 && t == question_.ray.t_min) || (way < 0 && t == question_.ray.t_max);
  }

  /// Appends a hit of the whole line where the ray's interval holds it.
  template <class Number>
  void add(ExactContacts& hits, Number t, Contact contact) const {
    if (is_in_interval(t, question_.ray.t_min, question_.ray.t_max)) hits.push_back({std::move(t), contact});
  }

 private:
  const RayQuestion& question_;
  ObjectRay<Ring> ray_;
};

/// The answer to the question, each number of it rounded once.
[[nodiscard]] RayAnswer answer(const ExactIntersection& exact, Precision precision);

}  // namespace rayproof::oracle
