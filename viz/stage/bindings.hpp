#pragma once
/// \file
/// Each topic's table of how its named values look; a new topic is a function here and a line in
/// bindings.cpp.

#include "viz/stage/items.hpp"

namespace rayproof::viz {

[[nodiscard]] std::vector<Binding> sphere_bindings();

}  // namespace rayproof::viz
