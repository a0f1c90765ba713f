#pragma once
/// \file
/// The recording arithmetic: every number is kept three times, rounded, with its error bound, and with
/// hundreds of bits more, and every operation is written to a Recording.

#include <concepts>
#include <rayproof/arithmetics/bounded.hpp>
#include <rayproof/arithmetics/recording.hpp>
#include <rayproof/narration.hpp>
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
      id = tape->append(std::move(operation));
    }
  }
};

template <class T, class Shadow>
struct PlainOf<Recorded<T, Shadow>> {
  using type = T;
};

template <class T, class S>
[[nodiscard]] Recorded<T, S> select(BoundedMask mask, const Recorded<T, S>& yes, const Recorded<T, S>& no) {
  Recorded<T, S> chosen = mask.value ? yes : no;
  chosen.bounded = select(mask, yes.bounded, no.bounded);
  return chosen;
}

template <class T, class S>
[[nodiscard]] Recorded<T, S> sqrt(const Recorded<T, S>& x) {
  const S root = x.exact < 0 ? S(std::numeric_limits<S>::quiet_NaN()) : S(sqrt(x.exact));
  return {Operator::square_root, sqrt(x.bounded), root, x.id};
}

template <class T, class S>
[[nodiscard]] Recorded<T, S> abs(const Recorded<T, S>& x) {
  return {Operator::absolute, abs(x.bounded), S(abs(x.exact)), x.id};
}

template <class T, class S>
[[nodiscard]] Recorded<T, S> copysign(const Recorded<T, S>& x, const Recorded<T, S>& sign) {
  const S size = abs(x.exact);
  const S signed_size = std::signbit(sign.value()) ? S(-size) : size;
  return {Operator::copy_sign, copysign(x.bounded, sign.bounded), signed_size, x.id, sign.id};
}

template <class T, class S>
[[nodiscard]] Recorded<T, S> fma(const Recorded<T, S>& x, const Recorded<T, S>& y, const Recorded<T, S>& z) {
  const S sum = x.exact * y.exact + z.exact;
  return {Operator::fused_multiply_add, fma(x.bounded, y.bounded, z.bounded), sum, x.id, y.id, z.id};
}

template <class T, class S>
[[nodiscard]] Recorded<T, S> min(const Recorded<T, S>& x, const Recorded<T, S>& y) {
  Recorded<T, S> chosen = y < x ? y : x;
  chosen.bounded = min(x.bounded, y.bounded);
  return chosen;
}

template <class T, class S>
[[nodiscard]] Recorded<T, S> max(const Recorded<T, S>& x, const Recorded<T, S>& y) {
  Recorded<T, S> chosen = x < y ? y : x;
  chosen.bounded = max(x.bounded, y.bounded);
  return chosen;
}

// Steps and exponents are decisions, not measurements: the shadow follows the rounded value in them.

template <class T, class S>
[[nodiscard]] Recorded<T, S> exponent(const Recorded<T, S>& x) {
  const Bounded<T> e = exponent(x.bounded);
  return {Operator::exponent, e, S(e.value), x.id};
}

template <class T, class S>
[[nodiscard]] Recorded<T, S> floor(const Recorded<T, S>& x) {
  const Bounded<T> whole = floor(x.bounded);
  return {Operator::floor, whole, S(whole.value), x.id};
}

/// An infinite or NaN exponent leaves nothing to scale: the shadow then is what the rounded value is.
template <class T, class S>
[[nodiscard]] Recorded<T, S> scale_exponent(const Recorded<T, S>& x, const Recorded<T, S>& e) {
  const Bounded<T> rounded = scale_exponent(x.bounded, e.bounded);
  const bool scales = std::isfinite(e.value());
  const S scaled = scales ? S(ldexp(x.exact, static_cast<int>(e.value()))) : S(rounded.value);
  return {Operator::scale_exponent, rounded, scaled, x.id, e.id};
}

template <class T, class S>
struct Narrator<Recorded<T, S>> {
  static void step(const char* title) {
    if (Recording<S>* tape = Recording<S>::active()) tape->begin_step(title);
  }
};

/// Writes the name beside the number on the tape.
template <class T, class S>
[[nodiscard]] Recorded<T, S> named(const char* name, Recorded<T, S> value) {
  Recording<S>* tape = Recording<S>::active();
  if (tape == nullptr || value.id == unrecorded) return value;
  tape->at(value.id).name = name;
  tape->name(name, {value.id});
  return value;
}

/// Names a vector and, as name.x, name.y, name.z, its components.
template <class T, class S>
[[nodiscard]] Vec3<Recorded<T, S>> named(const char* name, Vec3<Recorded<T, S>> value) {
  Recording<S>* tape = Recording<S>::active();
  if (tape == nullptr || value.x.id == unrecorded) return value;
  tape->at(value.x.id).name = std::string(name) + ".x";
  tape->at(value.y.id).name = std::string(name) + ".y";
  tape->at(value.z.id).name = std::string(name) + ".z";
  tape->name(name, {value.x.id, value.y.id, value.z.id});
  return value;
}

}  // namespace rayproof
