#pragma once
/// \file
/// From a case that breaks a property to the finding that people read.

#include <atomic>
#include <optional>

#include "properties/engine/engine.hpp"

namespace rayproof {

/// A case that broke a property.
struct BrokenCase {
  const Subject& subject;
  const Property& property;
  const Case& one;
  const std::string& family;
  /// What came of asking, where that is known: asked again, a program may behave.
  const Outcome* outcome = nullptr;
};

/// Shrinks what was found and reports it to the listener; nothing where it cannot be shown again.
[[nodiscard]] std::optional<Finding> made_of(const BrokenCase& found, const Listener& listener,
                                             const std::atomic<bool>& stop);

}  // namespace rayproof
