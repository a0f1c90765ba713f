#pragma once

namespace rayproof::spawn {

/// The sides of a surface: `front` is where its normal points (outside a solid), `back` the other.
enum class Side { front, back };

}  // namespace rayproof::spawn
