#pragma once
#include <rayproof/difference_of_products.hpp>

namespace rayproof::triangle {

/// ab - cd with its exact sign, 0 included, as long as nothing underflows.
template <class T>
[[nodiscard]] constexpr T edge_function(const T& a, const T& b, const T& c, const T& d) {
  return difference_of_products(a, b, c, d);
}

}  // namespace rayproof::triangle
