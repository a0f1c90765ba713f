#pragma once
#include <string>

#include "bench/page/conclusions.hpp"

namespace rayproof::report {

/// The page out/report/index.html: one self-contained file.
[[nodiscard]] std::string to_page(const Conclusions& found);

}  // namespace rayproof::report
