#pragma once
/// \file
/// The oracle for a ray and a general quadric, and for enclosures that somebody claims to hold its roots.

#include <rayproof/implicit.hpp>
#include <rayproof/implicit/quadric.hpp>

#include "case/case.hpp"
#include "oracle/numbers/root.hpp"

namespace rayproof::oracle {

/// What the line of a ray and a quadric come to, of finite numbers: `linear` where the line has a direction
/// of the quadric at infinity; `constant` where there is no root, nor a chance of one. The roots on the whole
/// line are ascending, a double one once; none for `everything`.
[[nodiscard]] SolvedEquation meet(const Ray<double>& ray, const implicit::Quadric<double>& quadric);

/// How claimed enclosures do against the exact roots in the ray's interval.
struct EnclosureJudgement {
  bool is_ordered = true;            ///< ascending, inside the interval, nothing in common but ends
  bool has_missed = false;           ///< a root, or part of a line that is all roots, lies in no enclosure
  bool is_wrong_certain = false;     ///< a `certain` enclosure without exactly one crossing
  bool is_wrong_everywhere = false;  ///< `everywhere` where the line does not lie in the quadric
  std::size_t known = 0;             ///< exact roots in the ray's interval
  std::size_t tangents = 0;          ///< of the known, double ones
  std::size_t certain = 0;           ///< of the known, in certain enclosures
  std::size_t narrow = 0;            ///< of these, in enclosures of at most 64 ulps
  std::size_t idle = 0;              ///< undecided enclosures that hold no root
  double widest = 0;                 ///< width of the widest certain enclosure, in ulps of its root

  [[nodiscard]] bool is_right() const {
    return is_ordered && !has_missed && !is_wrong_certain && !is_wrong_everywhere;
  }
};

/// Judges enclosures of the hits of a ray whose direction is not 0.
[[nodiscard]] EnclosureJudgement judge(const Ray<double>& ray, const implicit::Quadric<double>& quadric,
                                       Precision precision, const EnclosedRoots<double>& claimed);

}  // namespace rayproof::oracle
