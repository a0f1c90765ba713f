#pragma once
/// \file
/// The ways to leave a surface, one line each.

#include <rayproof/method/topic.hpp>
#include <rayproof/spawn/error_bounds.hpp>
#include <rayproof/spawn/fixed.hpp>
#include <rayproof/spawn/integer_offset.hpp>
#include <rayproof/spawn/nothing.hpp>
#include <rayproof/spawn/proven.hpp>
#include <rayproof/spawn/relative.hpp>

namespace rayproof::spawn {

/// Every strategy has a `name`, a `title`, a `source`, `is_proven` (no false hit is possible),
/// `moves_to_surface` (starts from SurfacePoint::point, not from the hit), and `origin(SurfacePoint)`.
using Strategies = TypeList<Nothing, Fixed, Relative, ErrorBounds, IntegerOffset, Proven>;

}  // namespace rayproof::spawn
