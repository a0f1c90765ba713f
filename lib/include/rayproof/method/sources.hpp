#pragma once
/// \file
/// The sources that several methods are taken from. A source that one method alone has stands beside its
/// kernel.

#include <rayproof/method/contract.hpp>

namespace rayproof::sources {

/// Line and sphere in place of Embree's intersection; barycentric coordinates in the plane.
inline constexpr Source drabek{"P. Drábek", "Geometrie pro počítačovou grafiku", 2017};
/// A lecture of unknown author: sphere, plane, parallelepiped.
inline constexpr Source lecture_001{"(lecture)", "Algoritm peresecheniya lucha s prosteishimi ob'ektami",
                                    2022};
/// Triangle by its plane; elliptic cylinder.
inline constexpr Source maric{"A. Marić", "3D računalna grafika: 1. zadaća", 2023};
/// Raycasting: camera, planes, triangles, polygons, sphere, quadratic, slabs, transformed objects.
inline constexpr Source ban{"R. Bán", "Számítógépes grafika: Raycasting", 2022};
/// The discriminant formed at the ray point nearest to the centre.
inline constexpr Source haines_2019{
    "E. Haines, J. Günther, T. Akenine-Möller",
    "Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems ch. 7", 2019};
/// The branch of the quadratic formula without cancellation.
inline constexpr Source press{"W. Press et al.", "Numerical Recipes, 5.6 Quadratic and Cubic Equations",
                              1992};
/// Expansions: exact sums and products of floats, and signs that need no more digits than the case does.
inline constexpr Source shewchuk{
    "J. R. Shewchuk", "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates",
    1997};

/// A rounding test on a quick answer with a proven bound, and an accurate one where it fails.
inline constexpr Source ziv{
    "A. Ziv", "Fast Evaluation of Elementary Mathematical Functions with Correctly Rounded Last Bit", 1991};

}  // namespace rayproof::sources
