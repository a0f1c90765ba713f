#pragma once
/// \file
/// A function's parameters: which letter of a pattern each is, and which numbers it is computed in.

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "answering/signature.hpp"

namespace rayproof::answering {

/// The element of a std::vector or a std::span of constants; void of anything else.
template <class L>
struct ElementOf {
  using Type = void;
};
template <class E>
struct ElementOf<std::vector<E>> {
  using Type = E;
};
template <class E>
struct ElementOf<std::span<const E>> {
  using Type = E;
};

template <class A>
inline constexpr bool is_ray = false;
template <class T>
inline constexpr bool is_ray<Ray<T>> = true;

template <class A>
inline constexpr bool is_triple_of_vectors = false;
template <class V>
inline constexpr bool is_triple_of_vectors<std::array<V, 3>> = VectorOf<V, 3>;

/// Three numbers in a row, in the manner of C.
template <class A>
inline constexpr bool is_pointer_to_three = std::is_pointer_v<A>&& std::is_const_v<std::remove_pointer_t<A>>&&
    std::is_floating_point_v<std::remove_pointer_t<A>>;

/// The transform of a case, object to world.
template <class A>
inline constexpr bool is_matrix = false;
template <class T>
inline constexpr bool is_matrix<glm::mat<4, 4, T>> = true;

/// The pattern's letter for a parameter that is read: FieldRow's letters, `R` for a ray, `S` for a structure,
/// `M` for the transform;
/// 0 for what no case can give.
template <class A>
[[nodiscard]] constexpr char letter_of() {
  using Element = typename ElementOf<A>::Type;
  if constexpr (is_ray<A>)
    return 'R';
  else if constexpr (is_matrix<A>)
    return 'M';
  else if constexpr (std::is_same_v<A, bool>)
    return 'b';
  else if constexpr (std::floating_point<A>)
    return 'n';
  else if constexpr (VectorOf<A, 3> || is_pointer_to_three<A>)
    return 'v';
  else if constexpr (VectorOf<A, 2>)
    return 'p';
  else if constexpr (is_triple_of_vectors<A>)
    return 'a';
  else if constexpr (VectorOf<Element, 3>)
    return 'V';
  else if constexpr (VectorOf<Element, 2>)
    return 'P';
  else if constexpr (is_structure<A>())
    return 'S';
  else
    return '\0';
}

/// The number type that a parameter shows; void where it shows none.
template <class A>
[[nodiscard]] constexpr auto number_shown() {
  using Element = typename ElementOf<A>::Type;
  if constexpr (std::floating_point<A>)
    return A{};
  else if constexpr (is_matrix<A>)
    return typename A::value_type{};
  else if constexpr (is_pointer_to_three<A>)
    return std::remove_cvref_t<decltype(*std::declval<A>())>{};
  else if constexpr (VectorOf<A, 3> || VectorOf<A, 2>)
    return typename NumberOf<A>::Type{};
  else if constexpr (!std::is_void_v<Element>)
    return number_shown<Element>();
  else if constexpr (!std::is_void_v<typename StructureNumber<A>::Type>)
    return typename StructureNumber<A>::Type{};
}

/// Whether every parameter is one that a case gives, or is written to.
template <class... P>
[[nodiscard]] constexpr bool are_given(std::type_identity<std::tuple<P...>>) {
  return ((is_output<P> || letter_of<std::decay_t<P>>() != '\0') && ...);
}

/// Whether a parameter that is read shows which numbers the function computes with.
template <class... P>
[[nodiscard]] constexpr bool show_a_number(std::type_identity<std::tuple<P...>>) {
  return (!std::is_void_v<decltype(number_shown<std::decay_t<P>>())> || ...);
}

/// The letters of the parameters that are read.
template <class... P>
[[nodiscard]] std::string pattern_of(std::type_identity<std::tuple<P...>>) {
  std::string pattern;
  const auto add = [&pattern]<class One>(std::type_identity<One>) {
    if constexpr (!is_output<One>) pattern += letter_of<std::decay_t<One>>();
  };
  (add(std::type_identity<P>{}), ...);
  return pattern;
}

/// A pattern in words: "a vector, a vector, a number".
[[nodiscard]] inline std::string in_words(std::string_view pattern) {
  std::string words;
  for (const char letter : pattern) {
    words += words.empty() ? "" : ", ";
    words += letter == 'R'   ? "a ray"
             : letter == 'M' ? "a matrix"
             : letter == 'b' ? "a bool"
             : letter == 'n' ? "a number"
             : letter == 'v' ? "a vector"
             : letter == 'p' ? "a vector of two numbers"
             : letter == 'a' ? "three vectors"
             : letter == 'V' ? "a list of vectors"
             : letter == 'P' ? "a list of vectors of two numbers"
                             : "a shape";
  }
  return words.empty() ? "nothing" : words;
}

/// What shows no number is refused where the function is made.
[[nodiscard]] constexpr double first_number(std::type_identity<std::tuple<>>) { return 0; }

/// The type of the numbers that a function computes with: that of the first parameter that shows one.
template <class P, class... Rest>
[[nodiscard]] constexpr auto first_number(std::type_identity<std::tuple<P, Rest...>>) {
  if constexpr (std::is_void_v<decltype(number_shown<std::decay_t<P>>())>) {
    return first_number(std::type_identity<std::tuple<Rest...>>{});
  } else {
    return number_shown<std::decay_t<P>>();
  }
}

}  // namespace rayproof::answering
