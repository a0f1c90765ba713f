#pragma once
/// \file
/// What a guest's answers hold, found out by asking it.

#include <atomic>
#include <cstdint>
#include <vector>

#include "subjects/subject.hpp"

namespace rayproof {

/// A case without the answer that it should have got.
struct Failure {
  std::string subject{};  ///< its full name
  Case one{};
  Outcome outcome{};
};

/// Asks the guest some cases of every family of its topic, and puts down in `abilities` what its answers
/// hold: whether it ever gives two hits, a t, a contact, a point, a normal, barycentric coordinates, a point
/// on the boundary; and whether it has a rule for tangents, edges and ends of the interval. A verdict there
/// that is wrong now and then is its rounding's; one that is wrong two times in three is a rule.
///
/// Asks nothing of a subject with a contract of its own. Stops early once `stop` is true, or after a failure
/// or two, which it gives.
std::vector<Failure> learn_abilities(Subject& guest, std::uint64_t seed,
                                     const std::vector<Precision>& precisions, const std::atomic<bool>& stop);

}  // namespace rayproof
