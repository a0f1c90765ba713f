#pragma once
/// \file
/// What the written headers call where errors are planted: the expression as it is, or one of its mutants.
///
/// A written header (generator/) has `rpm::pick<17>(original, mutant 17, mutant 18, …)` where the kernel has
/// an expression. Which mutant is in force is chosen at run time, so that one shared object holds them all.

#include <type_traits>

#include "mutation/planted/fitting.hpp"
#include "mutation/planted/state.hpp"

namespace rayproof::mutation {

inline State state;

/// The mutant of an expression for which there is none: it doesn't compile with what stands there.
struct NoMutant {};
inline constexpr auto nothing = [] { return NoMutant{}; };
/// The mutant that leaves this one of several arguments as it is.
struct Unchanged {};
inline constexpr auto itself = [] { return Unchanged{}; };

namespace detail {

/// Mutant `which` of the list, as the type of the original; the original where it doesn't fit.
template <class R, class Original, class Mutant, class... More>
constexpr R chosen_of(int which, const Original& original, const Mutant& mutant, const More&... more) {
  if constexpr (sizeof...(More) > 0)
    if (which > 0) return chosen_of<R>(which - 1, original, more...);
  if constexpr (fits<R, decltype(mutant())>)
    return fitted<R>(mutant());
  else
    return original();
}

template <class R, class Mutant>
void note_one(int number, const R& kept, const Mutant& mutant) {
  if constexpr (fits<R, decltype(mutant())>)
    state.note(number, is_same(kept, fitted<R>(mutant())) ? Meeting::same : Meeting::other);
  else
    state.note(number, Meeting::no_mutant);
}

/// The original, and a note of each mutant that differs from it. What the mutants call is not noted.
template <class R, class Original, class... Mutants>
R noted(int first, const Original& original, const Mutants&... mutants) {
  R kept = original();
  state.is_noting = false;
  int number = first;
  (note_one<R>(number++, kept, mutants), ...);
  state.is_noting = true;
  return kept;
}

}  // namespace detail

/// The original's value, or that of the mutant in force. Mutant `First` is the first of `mutants`.
template <int First, class Original, class... Mutants>
constexpr auto pick(const Original& original, const Mutants&... mutants) {
  using R = std::decay_t<decltype(original())>;
  if (std::is_constant_evaluated()) return R(original());
  const auto which = static_cast<unsigned>(state.chosen - First);
  if (which < sizeof...(mutants)) [[unlikely]]
    return detail::chosen_of<R>(static_cast<int>(which), original, mutants...);
  if (state.is_noting) [[unlikely]]
    return detail::noted<R>(First, original, mutants...);
  return R(original());
}

namespace detail {

/// Only a mutant of this type, const or not.
template <class R, class Mutant>
constexpr auto alike(const Mutant& mutant) {
  if constexpr (std::is_same_v<R, std::decay_t<decltype(mutant())>>)
    return mutant;
  else
    return nothing;
}

/// Whether what the two give are variables of one type, or the second is no mutant for the first.
template <class Own, class Other>
inline constexpr bool are_variables =
    std::is_same_v<Own, Other> || !std::is_same_v<std::decay_t<Own>, std::decay_t<Other>>;

/// Where a variable stands.
template <class Variable>
constexpr auto address_of(const Variable& variable) {
  return [&variable] {
    if constexpr (std::is_reference_v<decltype(variable())>)
      return VariableAddress{&variable()};
    else
      return NoMutant{};
  };
}

}  // namespace detail

/// As pick, of an argument that some mutants swap with its neighbour: only with one of its own type. A
/// variable stays the variable that it is, since what is called may keep a reference to it.
template <int First, class Original, class... Mutants>
constexpr decltype(auto) swapped(const Original& original, const Mutants&... mutants) {
  using Own = decltype(original());
  using R = std::decay_t<Own>;
  if constexpr (std::is_class_v<R> && std::is_lvalue_reference_v<Own> &&
                (detail::are_variables<Own, decltype(mutants())> && ...))
    return *pick<First>(detail::address_of(original), detail::address_of(detail::alike<R>(mutants))...).at;
  else
    return pick<First>(original, detail::alike<R>(mutants)...);
}

/// A list of operations; the first is that of the kernel.
template <class Original, class... Mutants>
struct Operations {};

/// One of the operations applied to the operands.
template <int First, class Original, class... Mutants, class... Operands>
constexpr auto apply(Operations<Original, Mutants...> /*which*/, const Operands&... operands) {
  return pick<First>([&] { return Original::of(operands...); }, [&] { return Mutants::of(operands...); }...);
}

namespace detail {

/// a && b where `stop` is false, a || b where it is true: b is only asked where a is not `stop`. The mutants
/// are the other of the two, a alone, and b alone.
template <int First, class A, class B>
constexpr bool joined(bool stop, const A& a, const B& b) {
  if (std::is_constant_evaluated()) return a() == stop ? stop : bool(b());
  switch (state.chosen - First) {
    case 0:
      return a() != stop ? !stop : bool(b());
    case 1:
      return bool(a());
    case 2:
      return bool(b());
    default:
      break;
  }
  const bool first = bool(a());
  const bool result = first == stop ? stop : bool(b());
  if (state.is_noting) {
    state.note(First, meeting(first == stop || result != !stop));  // b is not asked where the kernel doesn't
    state.note(First + 1, meeting(result != first));
    state.note(First + 2, meeting(first == stop));
  }
  return result;
}

}  // namespace detail

/// a && b, of masks that are no bools, too: those are asked both.
template <int First, class A, class B>
constexpr auto both(const A& a, const B& b) {
  if constexpr (std::is_same_v<decltype(a() && b()), bool>)
    return detail::joined<First>(false, a, b);
  else
    return pick<First>([&] { return a() && b(); }, [&] { return a() || b(); }, a, b);
}
/// a || b, likewise.
template <int First, class A, class B>
constexpr auto either(const A& a, const B& b) {
  if constexpr (std::is_same_v<decltype(a() || b()), bool>)
    return detail::joined<First>(true, a, b);
  else
    return pick<First>([&] { return a() || b(); }, [&] { return a() && b(); }, a, b);
}

/// Whether the mutant of a statement is in force.
template <int Number>
constexpr bool is(bool compiles) {
  if (std::is_constant_evaluated() || !compiles) return false;
  if (state.is_noting) state.note(Number, Meeting::other);
  return state.chosen == Number;
}

}  // namespace rayproof::mutation

namespace rpm = rayproof::mutation;

#include "mutation/planted/operations.hpp"
