#pragma once
/// \file
/// Whether an estimate is enough.

#include "oracle/numbers/ring.hpp"

namespace rayproof::oracle::test {

/// Whether what `compute` does leaves a doubt.
template <class Compute>
[[nodiscard]] bool is_doubtful(const Compute& compute) {
  Doubt::clear();
  (void)compute();
  return Doubt::is_noted();
}

}  // namespace rayproof::oracle::test
