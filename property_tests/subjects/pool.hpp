#pragma once
/// \file
/// Instances that are kept and lent, since starting one may take long.

#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "subjects/outcome.hpp"

namespace rayproof {

using StartAnswerer = std::function<std::unique_ptr<Answerer>()>;

/// A function like `start` that hands out an instance which nobody uses at present, and only where there is
/// none starts another. What it hands out goes back when it ends, into the pool that all copies of the
/// function share.
[[nodiscard]] StartAnswerer pooled(StartAnswerer start);

}  // namespace rayproof
