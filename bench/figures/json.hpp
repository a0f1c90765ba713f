#pragma once
#include <string>

#include "bench/figures/row.hpp"

namespace rayproof::report {

/// The figures as the case format's "Figures" has them. The floor has no errors: null. Infinities are "inf".
[[nodiscard]] std::string to_json(const Measurements& figures);

}  // namespace rayproof::report
