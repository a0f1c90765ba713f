#pragma once
/// \file
/// The registration of the library's layer: one line for each topic (a shape, or a question like the
/// quadratic).

#include <rayproof/box/methods.hpp>
#include <rayproof/cylinder/methods.hpp>
#include <rayproof/method/topic.hpp>
#include <rayproof/parallelepiped/methods.hpp>
#include <rayproof/plane/methods.hpp>
#include <rayproof/point_in_polygon/methods.hpp>
#include <rayproof/polygon/methods.hpp>
#include <rayproof/quadratic/methods.hpp>
#include <rayproof/sphere/methods.hpp>
#include <rayproof/triangle/methods.hpp>

namespace rayproof {

/// Every topic the library has methods for. A topic has a `name`, a `robust_bound`, the list `Methods`, and
/// `Problem<T>`; one with `is_batched` has its methods built as batch kernels, too. One with `has_columns`,
/// whose shape is numbers of type T and nothing else, has kernels for one ray and many shapes
/// (objects/kernels.hpp).
using Topics = TypeList<quadratic::Topic,         //
                        point_in_polygon::Topic,  //
                        plane::Topic,             //
                        triangle::Topic,          //
                        polygon::Topic,           //
                        sphere::Topic,            //
                        box::Topic,               //
                        parallelepiped::Topic,    //
                        cylinder::Topic>;

/// Whether a topic has batch kernels.
template <class Topic>
inline constexpr bool is_batched = requires {
  requires Topic::is_batched;
};

/// Whether many of its shapes are met by one ray in packs.
template <class Topic>
inline constexpr bool has_columns = requires {
  requires Topic::has_columns;
};

}  // namespace rayproof
