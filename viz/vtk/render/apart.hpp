#pragma once
/// \file
/// Work that may crash, done in a process of its own.

#include <functional>
#include <optional>
#include <rayproof/triangle.hpp>
#include <vector>

namespace rayproof::render {

/// What `make` gives, made in a child process that ends with it; nothing where it throws, crashes, or takes
/// more than a minute of processor time. What the child says on standard error is lost. Call it before there
/// are other threads.
[[nodiscard]] std::optional<std::vector<Triangle<double>>> made_apart(
    const std::function<std::vector<Triangle<double>>()>& make);

}  // namespace rayproof::render
