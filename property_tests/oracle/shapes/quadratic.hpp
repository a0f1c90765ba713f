#pragma once
/// \file
/// The oracle for the quadratic equation.

#include "oracle/judge/judgement.hpp"

namespace rayproof::oracle {

/// The exact kind and the correctly rounded roots of ax² + bx + c = 0.
[[nodiscard]] QuadraticAnswer<double> answer(const Quadratic<double>& equation, Precision precision);

/// Judges the kind and the roots somebody claims.
[[nodiscard]] Judgement judge(const Quadratic<double>& equation, Precision precision,
                              const QuadraticAnswer<double>& claimed);

}  // namespace rayproof::oracle
