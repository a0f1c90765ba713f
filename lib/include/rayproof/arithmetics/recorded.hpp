#pragma once
/// \file
/// The recording arithmetic: every number is kept three times, rounded, with its error bound, and with
/// hundreds of bits more, and every operation is written to a Recording.

#include <concepts>
#include <rayproof/arithmetics/bounded.hpp>
#include <rayproof/arithmetics/recording.hpp>
#include <rayproof/method/narration.hpp>
#include <rayproof/vec3.hpp>
#include <type_traits>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// A number of type `T`, what the same formula gives for it in `Shadow` along the same path, and where it
/// came from.
///
/// `Shadow` is any real type with 200 bits more than `T` and a wide exponent range (boost::multiprecision's
/// cpp_bin_float serves); its functions are found by argument-dependent lookup. Inputs and literals are
/// exact. Rounds bit for bit as `T` does; comparisons, `select` and signs follow the rounded value, in the
/// shadow too.
template <std::floating_point T, class Shadow>
struct Recorded : Comparable<Recorded<T, Shadow>> {
  using Plain = T;

  Bounded<T> bounded{};
  Shadow exact{};
  OperationId id = unrecorded;

  Recorded() = default;
  template <class U>
  requires std::is_arithmetic_v<U> Recorded(U input)
      : Recorded(Operator::constant, static_cast<T>(input), static_cast<T>(input)) {}
  /// The result of an operation on recorded operands.
  Recorded(Operator op, const Bounded<T>& rounded, const Shadow& shadow, OperationId x = unrecorded,
           OperationId y = unrecorded, OperationId z = unrecorded)
      : bounded(rounded), exact(shadow) {
    if (auto* tape = Recording<Shadow>::active()) {
      id = tape->append({.op = op, .operands = {x, y, z}, .exact = exact});
      tape->measure(id, bounded.value, bounded.error);
    }
  }

  [[nodiscard]] T value() const { return bounded.value; }
  /// The same operation's number with another value or bound: what changes them is no step of the formula.
  template <class U>
  [[nodiscard]] Recorded<U, Shadow> with(const Bounded<U>& other) const {
    Recorded<U, Shadow> changed;
    changed.bounded = other;
    changed.exact = exact;
    changed.id = id;
    return changed;
  }

  friend Recorded operator-(const Recorded& x) { return {Operator::negate, -x.bounded, -x.exact, x.id}; }
  friend Recorded operator+(const Recorded& x, const Recorded& y) {
    return {Operator::add, x.bounded + y.bounded, x.exact + y.exact, x.id, y.id};
  }
  friend Recorded operator-(const Recorded& x, const Recorded& y) {
    return {Operator::subtract, x.bounded - y.bounded, x.exact - y.exact, x.id, y.id};
  }
  friend Recorded operator*(const Recorded& x, const Recorded& y) {
    return {Operator::multiply, x.bounded * y.bounded, x.exact * y.exact, x.id, y.id};
  }
  friend Recorded operator/(const Recorded& x, const Recorded& y) {
    return {Operator::divide, x.bounded / y.bounded, x.exact / y.exact, x.id, y.id};
  }

  friend BoundedMask operator<(const Recorded& x, const Recorded& y) { return x.bounded < y.bounded; }
  friend BoundedMask operator<=(const Recorded& x, const Recorded& y) { return x.bounded <= y.bounded; }
  friend BoundedMask operator==(const Recorded& x, const Recorded& y) { return x.bounded == y.bounded; }
};

template <class T, class S>
struct Narrator<Recorded<T, S>> {
  static void step(const Step& step) {
    if (Recording<S>* tape = Recording<S>::active())
      tape->steps.push_back({std::string(step.title), std::string(step.meaning)});
  }
};

/// Writes the name beside the number on the tape, and measures the number anew: it may have been narrowed
/// since, and what is named and shown is the number that the kernel goes on with.
template <class T, class S>
[[nodiscard]] Recorded<T, S> named(const char* name, Recorded<T, S> value) {
  Recording<S>* tape = Recording<S>::active();
  if (tape == nullptr || value.id == unrecorded) return value;
  tape->measure(value.id, value.value(), value.bounded.error);
  tape->at(value.id).name = name;
  tape->name(name, {value.id});
  return value;
}

/// Names a vector and, as name.x, name.y, name.z, its components.
template <class T, class S>
[[nodiscard]] Vec3<Recorded<T, S>> named(const char* name, Vec3<Recorded<T, S>> value) {
  Recording<S>* tape = Recording<S>::active();
  if (tape == nullptr || value.x.id == unrecorded) return value;
  const auto name_component = [&](const Recorded<T, S>& component, const char* axis) {
    tape->measure(component.id, component.value(), component.bounded.error);
    tape->at(component.id).name = std::string(name) + axis;
  };
  name_component(value.x, ".x");
  name_component(value.y, ".y");
  name_component(value.z, ".z");
  tape->name(name, {value.x.id, value.y.id, value.z.id});
  return value;
}

}  // namespace rayproof

#include <rayproof/arithmetics/recorded_functions.hpp>  // IWYU pragma: export

#include <rayproof/rounding/as_before.hpp>
