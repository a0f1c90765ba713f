#pragma once
/// \file
/// Labels: what a generator really produced, judged by the oracle and not by the generator's intent.

#include <map>
#include <string>
#include <vector>

#include "generators/generators.hpp"

namespace rayproof {

/// What can be said of a case. Of a ray question: "hit" or "miss"; how the whole line's first hit touches, or
/// why there is none: "tangent", "edge", "vertex", "rim", "in surface", "parallel", "degenerate"; "sharp"
/// (the surface has no normal there: a solid's edge or corner, a rim); "behind" (a miss although the whole
/// line hits); "cut" (the interval leaves out some of the line's hits, not all); "from inside" (the line hits
/// on either side of t = 0). Of a quadratic: the kind of its roots. Of a point and a polygon: "inside",
/// "outside" or "boundary". Of any: "in reach" (all lengths within the domain of the bounded contracts).
[[nodiscard]] std::vector<std::string> labels_of(const Case& one);

/// The sample of each family that a run labels, or all its cases where they are fewer; from fewer than these
/// nothing follows about a small share.
inline constexpr unsigned label_sample = 4000;

/// The labels of a sample of a family's cases.
struct LabelCount {
  const Family* family = nullptr;
  Precision precision{};
  unsigned cases = 0;
  std::map<std::string, unsigned> counts{};

  [[nodiscard]] double share(const std::string& label) const;
  /// "hit 41.2 %, miss 58.8 %".
  [[nodiscard]] std::string shares() const;
  /// The shares the family missed by more than chance, each as a sentence; empty where all is well, or the
  /// sample is too small.
  [[nodiscard]] std::vector<std::string> missed() const;
};

/// Labels `cases` cases of the family.
[[nodiscard]] LabelCount count_labels(const Family& family, Precision precision, std::uint64_t seed,
                                      unsigned cases);

}  // namespace rayproof
