#pragma once
/// \file
/// One run of rayproof render.

#include <atomic>

#include "viz/programs/render/options.hpp"

namespace rayproof::render {

/// Reads the scene and does what the options ask for. Throws Stopped once `stop` is true, a Refusal, or a
/// std::runtime_error.
void run(const RenderOptions& options, const std::atomic<bool>& stop);

}  // namespace rayproof::render
