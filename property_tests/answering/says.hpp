#pragma once
/// \file
/// What a function's result says, by its type alone.

#include <concepts>
#include <iterator>
#include <tuple>
#include <utility>

#include "answering/vectors.hpp"

namespace rayproof::answering {

/// @{ A structure with t; with `hit`, whether there is one; with one of them, and a point or a normal beside
/// it.
template <class R>
concept RecordOfT = requires(const R& r) {
  { r.t } -> std::convertible_to<double>;
};
template <class R>
concept RecordOfHit = requires(const R& r) {
  { r.hit } -> std::convertible_to<bool>;
};
template <class R>
concept Record = RecordOfT<R> || RecordOfHit<R>;
/// @}
template <class R>
concept Maybe = requires(const R& r) {
  r.has_value();
  *r;
};
template <class R>
concept Pair = requires(const R& r) {
  { r.first } -> std::convertible_to<double>;
  r.second;
};
template <class R>
concept List = requires(const R& r) {
  std::begin(r);
  std::end(r);
};

/// What a result says, by its type alone.
struct Says {
  bool verdict = false;  ///< whether there is a hit, apart from its t
  bool t = false;
  bool all_hits = false;  ///< more than the nearest

  constexpr Says operator|(const Says& other) const {
    return {verdict || other.verdict, t || other.t, all_hits || other.all_hits};
  }
};

/// What is said by a result.
template <class R>
[[nodiscard]] constexpr Says says() {
  if constexpr (std::is_void_v<R>)
    return {};
  else if constexpr (std::integral<R> || std::is_enum_v<R>)
    return {.verdict = true};
  else if constexpr (std::floating_point<R>)
    return {.t = true};
  else if constexpr (requires {
                       &R::kind;
                       &R::roots;
                     })
    return {true, true, true};
  else if constexpr (Maybe<R>)
    return Says{.verdict = true} | says<std::remove_cvref_t<decltype(*std::declval<R>())>>();
  else if constexpr (named_size<R>() > 0 || Pair<R>)
    return {.t = true, .all_hits = named_size<R>() < 3};
  else if constexpr (Record<R>)
    return {.verdict = RecordOfHit<R>, .t = RecordOfT<R>};
  else if constexpr (List<R>)
    return {true, true, true};
  else
    return {};
}

/// What is said by a parameter that is written to: vectors are no t there.
template <class O>
[[nodiscard]] constexpr Says says_output() {
  if constexpr (named_size<O>() > 0 || array_size < O >> 0 || std::is_same_v<O, bool>)
    return {};
  else
    return says<O>();
}

}  // namespace rayproof::answering
