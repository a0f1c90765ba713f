#pragma once
/// \file
/// A mutant's value in the type of the original's, and whether the two are the same.

#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

namespace rayproof::mutation {

template <class X>
concept Expanded = requires(X x) {
  x.terms[0];
  x.count = std::size_t{1};
};
template <class X>
concept Vector = requires(X x) {
  x.x;
  x.y;
  x.z;
};
template <class X>
concept Planar = !Vector<X> && requires(X x) {
  x.x;
  x.y;
};
template <class X>
concept Growing = requires(const X& x) {
  x.terms().size();
};
template <class X>
concept Bounding = requires(const X& x) {
  x.value;
  x.error;
};

/// Where a variable stands: what is called may keep a reference to it.
template <class X>
struct VariableAddress {
  X* at;
};
template <class X>
VariableAddress(X*) -> VariableAddress<X>;
template <class X>
inline constexpr bool is_variable_address = false;
template <class X>
inline constexpr bool is_variable_address<VariableAddress<X>> = true;

/// Whether a mutant's value of type X can stand for one of type R.
template <class R, class X>
inline constexpr bool fits = [] {
  if constexpr (std::is_same_v<R, X>)
    return true;
  else if constexpr (std::is_same_v<R, bool> || std::is_same_v<X, bool>)
    return false;
  else if constexpr (std::is_arithmetic_v<R> && std::is_arithmetic_v<X>)
    return true;
  else if constexpr (Expanded<R> && Expanded<X>)
    return true;
  else if constexpr (Vector<R> && Vector<X>)
    return fits<std::decay_t<decltype(std::declval<R>().x)>, std::decay_t<decltype(std::declval<X>().x)>>;
  else
    return std::is_convertible_v<X, R>;
}();

/// The value in that type: an expansion with other room keeps its largest terms.
template <class R, class X>
constexpr R fitted(const X& x) {
  if constexpr (std::is_same_v<R, X>) {
    return x;
  } else if constexpr (Expanded<R> && Expanded<X>) {
    R result;
    const std::size_t lost = x.count > result.terms.size() ? x.count - result.terms.size() : 0;
    for (std::size_t i = lost; i < x.count; ++i) result.push(x.terms[i]);
    return result;
  } else if constexpr (Vector<R> && Vector<X>) {
    using Number = std::decay_t<decltype(std::declval<R>().x)>;
    return R{fitted<Number>(x.x), fitted<Number>(x.y), fitted<Number>(x.z)};
  } else {
    return static_cast<R>(x);
  }
}

/// Whether two values are the same bit for bit; of types that nothing is known of, never.
template <class R>
bool is_same(const R& a, const R& b) {
  if constexpr (std::is_arithmetic_v<R> || std::is_enum_v<R> || std::is_pointer_v<R> ||
                std::is_member_pointer_v<R>) {
    return std::memcmp(&a, &b, sizeof(R)) == 0;
  } else if constexpr (is_variable_address<R>) {
    return is_same(*a.at, *b.at);
  } else if constexpr (Expanded<R>) {
    bool same = a.count == b.count;
    for (std::size_t i = 0; same && i < a.count; ++i) same = is_same(a.terms[i], b.terms[i]);
    return same;
  } else if constexpr (Growing<R>) {
    bool same = a.terms().size() == b.terms().size();
    for (std::size_t i = 0; same && i < a.terms().size(); ++i) same = is_same(a.terms()[i], b.terms()[i]);
    return same;
  } else if constexpr (Vector<R>) {
    return is_same(a.x, b.x) && is_same(a.y, b.y) && is_same(a.z, b.z);
  } else if constexpr (Planar<R>) {
    return is_same(a.x, b.x) && is_same(a.y, b.y);
  } else if constexpr (Bounding<R>) {
    return is_same(a.value, b.value) && is_same(a.error, b.error);
  } else {
    return false;
  }
}

}  // namespace rayproof::mutation
