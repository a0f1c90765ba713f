#pragma once
#include "bench/contenders/contender.hpp"

namespace rayproof::report {

/// The oracle, as what is timed: for each case one exact verdict on the answer of the topic's first sound
/// method, of a ray's hits the nearest only, with the exact error of t.
[[nodiscard]] Contender oracle_contender(const std::string& topic, const std::vector<Case>& cases);

}  // namespace rayproof::report
