#pragma once
/// \file
/// The oracle for ray and disk.

#include "oracle/judge/judgement.hpp"

namespace rayproof::oracle {

/// The exact answer to a ray and a disk, under a transform or not.
[[nodiscard]] RayAnswer answer(const RayQuestion& question, const Disk<double>& disk, Precision precision);

/// Judges the hits somebody claims for a ray and a disk.
[[nodiscard]] Judgement judge(const RayQuestion& question, const Disk<double>& disk, Precision precision,
                              const RayAnswer& claimed);

}  // namespace rayproof::oracle
