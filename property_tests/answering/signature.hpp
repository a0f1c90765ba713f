#pragma once
/// \file
/// What a callable takes and returns.

#include <cstddef>
#include <functional>
#include <tuple>
#include <type_traits>

#include "answering/vectors.hpp"
#include "case/case.hpp"

namespace rayproof::answering {

/// Of a function, a function object or a lambda that is no template: its result and its parameters.
template <class F>
struct Signature {};
template <class F>
requires requires { &F::operator(); }
struct Signature<F> : Signature<decltype(&F::operator())> {};
template <class R, class... A>
struct Signature<R(A...)> {
  using Result = R;
  using Parameters = std::tuple<A...>;
};
template <class R, class... A>
struct Signature<R(A...) noexcept> : Signature<R(A...)> {};
template <class R, class... A>
struct Signature<R (*)(A...)> : Signature<R(A...)> {};
template <class R, class... A>
struct Signature<R (*)(A...) noexcept> : Signature<R(A...)> {};
template <class C, class R, class... A>
struct Signature<R (C::*)(A...)> : Signature<R(A...)> {};
template <class C, class R, class... A>
struct Signature<R (C::*)(A...) const> : Signature<R(A...)> {};
template <class C, class R, class... A>
struct Signature<R (C::*)(A...) const noexcept> : Signature<R(A...)> {};

/// What can be called once its parameters are known.
template <class F>
concept Function = requires {
  typename Signature<std::decay_t<F>>::Result;
};

/// A parameter that the function writes its result to.
template <class P>
inline constexpr bool is_output =
    std::is_lvalue_reference_v<P> && !std::is_const_v<std::remove_reference_t<P>>;

/// The number type of a structure of the library (Ray<T>, Sphere<T>, …); void of anything else.
template <class S>
struct StructureNumber {
  using Type = void;
};
template <template <class> class S, class T>
requires std::floating_point<T>
struct StructureNumber<S<T>> {
  using Type = T;
};

/// The structure `S` from the case format's `C`, where there is a way.
template <class S, class C>
[[nodiscard]] constexpr bool is_made_of() {
  using T = typename StructureNumber<S>::Type;
  if constexpr (std::is_same_v<S, C>) {
    return true;
  } else if constexpr (std::is_void_v<T>) {
    return false;
  } else if constexpr (requires(const C& c) {
                         { convert<T>(c) } -> std::same_as<S>;
                       }) {
    return true;
  } else {
    return requires(const C& c) {
      { convert<T>(library_shape(c)) } -> std::same_as<S>;
    };
  }
}

/// As `is_made_of` says; `given` is of a form that `S` has.
template <class S, class C>
[[nodiscard]] S make_structure(const C& given) {
  using T = typename StructureNumber<S>::Type;
  if constexpr (std::is_same_v<S, C>) {
    return given;
  } else if constexpr (requires {
                         { convert<T>(given) } -> std::same_as<S>;
                       }) {
    return convert<T>(given);
  } else {
    return convert<T>(library_shape(given));
  }
}

/// Calls `act(std::type_identity<C>{})` for every shape of the case format, and for the questions without a
/// ray.
constexpr void each_structure(auto&& act) {
  const auto each = [&]<class... Shapes>(std::type_identity<std::variant<Shapes...>>) {
    (act(std::type_identity<Shapes>{}), ...);
  };
  each(std::type_identity<Shape>{});
  act(std::type_identity<Quadratic<double>>{});
  act(std::type_identity<PointAndPolygon<double>>{});
}

/// Whether `S` holds some shape, or some question without a ray.
template <class S>
[[nodiscard]] constexpr bool is_structure() {
  bool is_one = false;
  each_structure([&]<class C>(std::type_identity<C>) { is_one = is_one || is_made_of<S, C>(); });
  return is_one;
}

}  // namespace rayproof::answering
