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

namespace rayproof {

/// A number of type `T`, what the same formula gives for it in `Shadow` along the same path, and where it
/// came from.
///
/// `Shadow` is any real type with 200 bits more than `T` and a wide exponent range (boost::multiprecision's
/// cpp_bin_float serves); its functions are found by argument-dependent lookup. Inputs and literals are
/// exact. Rounds bit for bit as `T` does; comparisons, `select` and signs follow the rounded value, in the
/// shadow too.
template <std::floating_point T, class Shadow>
struct Recorded {
  using Tape = Recording<Shadow>;

  Bounded<T> bounded{};
  Shadow exact{};
  OperationId id = unrecorded;

  Recorded() = default;
  template <class U>
  requires std::is_arithmetic_v<U> Recorded(U input)
      : bounded(static_cast<T>(input)), exact(static_cast<T>(input)) {
    record(Operator::constant, {unrecorded, unrecorded, unrecorded});
  }
  /// The result of an operation on recorded operands.
  Recorded(Operator op, const Bounded<T>& rounded, const Shadow& shadow, OperationId x,
           OperationId y = unrecorded, OperationId z = unrecorded)
      : bounded(rounded), exact(shadow) {
    record(op, {x, y, z});
  }

  [[nodiscard]] T value() const { return bounded.value; }

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
  friend BoundedMask operator>(const Recorded& x, const Recorded& y) { return x.bounded > y.bounded; }
  friend BoundedMask operator<=(const Recorded& x, const Recorded& y) { return x.bounded <= y.bounded; }
  friend BoundedMask operator>=(const Recorded& x, const Recorded& y) { return x.bounded >= y.bounded; }
  friend BoundedMask operator==(const Recorded& x, const Recorded& y) { return x.bounded == y.bounded; }
  friend BoundedMask operator!=(const Recorded& x, const Recorded& y) { return x.bounded != y.bounded; }

 private:
  void record(Operator op, const std::array<OperationId, 3>& operands) {
    if (Tape* tape = Tape::active()) {
      Operation<Shadow> operation{op, operands};
      operation.value = static_cast<double>(bounded.value);
      operation.exact = exact;
      operation.error_bound = static_cast<double>(bounded.error);
      operation.bits_lost = bits_lost(bounded.value, exact);
      operation.digits = std::numeric_limits<T>::digits;
      id = tape->append(std::move(operation));
    }
  }
};

template <class T, class Shadow>
struct PlainOf<Recorded<T, Shadow>> {
  using type = T;
};

template <class T, class S>
struct Narrator<Recorded<T, S>> {
  static void step(const Step& step) {
    if (Recording<S>* tape = Recording<S>::active()) tape->steps.push_back({step.title, step.meaning});
  }
};

/// Brings an operation's record up to its number, which may have been narrowed since (arithmetics/wide.hpp):
/// what is named and shown is the number that the kernel goes on with.
template <class T, class S>
void refresh(Recording<S>& tape, const Recorded<T, S>& number) {
  Operation<S>& operation = tape.at(number.id);
  operation.value = static_cast<double>(number.value());
  operation.error_bound = static_cast<double>(number.bounded.error);
  operation.bits_lost = bits_lost(number.value(), operation.exact);
  operation.digits = std::numeric_limits<T>::digits;
  operation.bits_lost_here = operation.bits_lost - tape.lost_before(operation);
}

/// Writes the name beside the number on the tape.
template <class T, class S>
[[nodiscard]] Recorded<T, S> named(const char* name, Recorded<T, S> value) {
  Recording<S>* tape = Recording<S>::active();
  if (tape == nullptr || value.id == unrecorded) return value;
  refresh(*tape, value);
  tape->at(value.id).name = name;
  tape->name(name, {value.id});
  return value;
}

/// Names a vector and, as name.x, name.y, name.z, its components.
template <class T, class S>
[[nodiscard]] Vec3<Recorded<T, S>> named(const char* name, Vec3<Recorded<T, S>> value) {
  Recording<S>* tape = Recording<S>::active();
  if (tape == nullptr || value.x.id == unrecorded) return value;
  for (const Recorded<T, S>& component : {value.x, value.y, value.z}) refresh(*tape, component);
  tape->at(value.x.id).name = std::string(name) + ".x";
  tape->at(value.y.id).name = std::string(name) + ".y";
  tape->at(value.z.id).name = std::string(name) + ".z";
  tape->name(name, {value.x.id, value.y.id, value.z.id});
  return value;
}

}  // namespace rayproof

#include <rayproof/arithmetics/recorded_functions.hpp>  // IWYU pragma: export
