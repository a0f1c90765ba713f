#pragma once
/// \file
/// The registration of the library's layer: one line for each topic (a shape, or a question like the
/// quadratic).

#include <rayproof/quadratic/methods.hpp>
#include <rayproof/sphere/methods.hpp>
#include <rayproof/type_list.hpp>

namespace rayproof {

/// Every topic the library has methods for. A topic has a `name`, a `robust_bound`, the list `Methods`, and
/// `Problem<T>`.
using Topics = TypeList<quadratic::Topic,  //
                        sphere::Topic>;

}  // namespace rayproof
