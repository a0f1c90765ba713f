#pragma once
/// \file
/// The registration of the case's layer: the shapes a ray question can hold.

#include <variant>

#include "case/shapes/sphere.hpp"

namespace rayproof {

/// Every shape of the case format, one line each.
using Shape = std::variant<  //
    Sphere<double>           //
    >;

}  // namespace rayproof
