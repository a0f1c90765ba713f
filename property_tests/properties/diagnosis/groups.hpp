#pragma once
/// \file
/// Groups of failing cases, each with its cause, made ready to be read.

#include "properties/diagnosis/diagnose.hpp"
#include "properties/diagnosis/examination/examination.hpp"

namespace rayproof::diagnosis {

/// Counts small rests with the largest group, and says of each group in words what it is.
void finish(std::vector<Diagnosis>& groups, const Examination& examination);

}  // namespace rayproof::diagnosis
