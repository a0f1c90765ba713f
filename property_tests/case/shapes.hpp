#pragma once
/// \file
/// The registration of the case's layer: the shapes a ray question can hold.

#include <variant>

#include "case/shapes/box.hpp"
#include "case/shapes/cylinder.hpp"
#include "case/shapes/parallelepiped.hpp"
#include "case/shapes/plane.hpp"
#include "case/shapes/polygon.hpp"
#include "case/shapes/sphere.hpp"
#include "case/shapes/triangle.hpp"

namespace rayproof {

/// Every shape of the case format, one line each. (The first is what an empty question holds.)
using Shape = std::variant<  //
    Sphere<double>,          //
    ImplicitPlane,           //
    PointNormalPlane,        //
    ParametricPlane,         //
    Triangle<double>,        //
    Polygon<double>,         //
    Box<double>,             //
    Parallelepiped<double>,  //
    Cylinder<double>         //
    >;

}  // namespace rayproof
