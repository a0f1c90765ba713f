#pragma once
/// \file
/// Of programs: one fault breaks many properties, in both precisions, and is one finding all the same.

#include <vector>

#include "properties/finding.hpp"

namespace rayproof {

/// Leaves out what is found by a twin of a case (scaled, reversed, moved) of a program that answers wrongly
/// to cases themselves: a twin is a case like any other.
void leave_out_twins(std::vector<Finding>& findings);

/// How bad a finding is.
using KindOf = FindingKind (*)(const Finding&);
/// What the cause of a finding says, if any is known.
struct CauseSays {
  bool (*is_named)(const Finding&) = nullptr;    ///< a model names what is wrong on a boundary
  bool (*is_avoided)(const Finding&) = nullptr;  ///< no more than that a small change avoids it
  bool (*is_part)(const Finding&, const Finding& of) = nullptr;  ///< of what the other's cause says
  bool (*is_extreme)(const Finding&) = nullptr;                  ///< its case has very large or small numbers
  bool (*is_zero_alone)(const Finding&) = nullptr;  ///< of what is small only that it is wrong where it is 0
};

/// Makes one of the findings of a program that have one cause: the simplest case of the gravest kind, with
/// the cases of all. Those without a known cause are one for verdict and t together, and one for each other
/// property, and none where a cause is known for its kind.
void put_together(std::vector<Finding>& findings, KindOf gravity, const CauseSays& says);

}  // namespace rayproof
