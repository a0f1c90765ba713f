#pragma once
/// \file
/// The bound that Claim::robust speaks of, for each topic.

#include <optional>
#include <string_view>

namespace rayproof {

/// The verdict band and residual, in the topic's units with far_power 0, that the best plain methods of the
/// topic keep; nothing where the topic has no such bound.
[[nodiscard]] std::optional<double> robust_bound(std::string_view topic);

}  // namespace rayproof
