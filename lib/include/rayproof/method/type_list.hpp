#pragma once
/// \file
/// A list of types, and running something once for each of them.

#include <cstddef>
#include <type_traits>

namespace rayproof {

template <class... Types>
struct TypeList {
  static constexpr std::size_t size = sizeof...(Types);

  /// Calls `visit(std::type_identity<T>{})` for each type of the list, in order.
  template <class Visit>
  static constexpr void for_each(Visit&& visit) {
    (visit(std::type_identity<Types>{}), ...);
  }
};

}  // namespace rayproof
