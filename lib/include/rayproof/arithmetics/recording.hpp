#pragma once
/// \file
/// What a kernel did, operation by operation: the tape that the recording arithmetic writes.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <rayproof/arithmetic.hpp>
#include <string>
#include <vector>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// The operations a recording distinguishes. `constant` is a number the kernel did not compute: an input
/// (which has a name) or a literal.
enum class Operator {
  constant,
  negate,
  add,
  subtract,
  multiply,
  divide,
  square_root,
  fused_multiply_add,
  absolute,
  copy_sign,
  exponent,
  scale_exponent,
  floor
};

/// Index of an operation in its recording; `unrecorded` for a number made while nothing was recording.
using OperationId = std::ptrdiff_t;
inline constexpr OperationId unrecorded = -1;

/// One operation and what became of the digits in it.
template <class Shadow>
struct Operation {
  Operator op = Operator::constant;
  std::array<OperationId, 3> operands{unrecorded, unrecorded, unrecorded};
  double value = 0;           ///< in the rounded arithmetic
  Shadow exact{};             ///< the same formula on the same path in the shadow arithmetic
  double error_bound = 0;     ///< running bound on |value - exact|
  double bits_lost = 0;       ///< log2(1 + error in ulps of the exact value), at most all the digits
  double bits_lost_here = 0;  ///< the part of it that no operand had lost before
  int digits = 0;             ///< of the format that it was rounded to
  std::ptrdiff_t step = -1;   ///< index into the recording's steps; -1 before the first
  std::string name{};         ///< as the kernel calls it; empty for a part of a formula
};

/// log2(1 + u), u the distance of `value` from `exact` in ulps of `exact` as a `T`: 0 for the exact value,
/// 0.58 for half an ulp. All the digits of `T` at most, and where one of the two is NaN or infinite and the
/// other is not: what has overflowed has no digits left, even where the exact value is too large for `T`.
template <class T, class Shadow>
[[nodiscard]] double bits_lost(T value, const Shadow& exact) {
  using std::abs;
  using std::frexp;
  using std::ldexp;
  using Limits = std::numeric_limits<T>;
  constexpr double all = Limits::digits;
  const bool both_are_nan = value != value && exact != exact;
  const Shadow rounded = value;
  if (both_are_nan || rounded == exact) return 0;
  const Shadow error = abs(rounded - exact);
  if (!std::isfinite(value) || exact == 0 || !(error < std::numeric_limits<Shadow>::infinity())) return all;
  int exponent = 0;
  (void)frexp(exact, &exponent);
  const int ulp = std::max(exponent, Limits::min_exponent) - Limits::digits;
  const auto ulps = static_cast<double>(ldexp(error, -ulp));
  return std::min(all, std::log2(1 + ulps));
}

/// A number or vector that the kernel named, in the order of naming.
struct NamedValue {
  std::string name;
  std::vector<OperationId> components;  ///< one, or three of a vector
  std::ptrdiff_t step = -1;
};

/// A step that the kernel began, in its own words (method/narration.hpp).
struct RecordedStep {
  std::string title;
  std::string meaning;
};

/// Collects what the recorded numbers of this thread do while it lives. While an inner recording lives, the
/// outer one rests; a number belongs to the recording it was made under and means nothing to another.
template <class Shadow>
class Recording {
 public:
  std::vector<Operation<Shadow>> operations{};
  std::vector<RecordedStep> steps{};
  std::vector<NamedValue> names{};

  Recording() : outer_(active_) { active_ = this; }
  ~Recording() { active_ = outer_; }
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

  /// The recording that listens now, or null.
  [[nodiscard]] static Recording* active() { return active_; }

  OperationId append(Operation<Shadow> operation) {
    operation.step = current_step();
    operations.push_back(std::move(operation));
    return static_cast<OperationId>(operations.size()) - 1;
  }
  /// Writes down what an operation has come to in format `T`. Its operands' losses count in that format:
  /// those of a float that was widened to double are larger than in float.
  template <class T>
  void measure(OperationId id, T value, T error_bound) {
    Operation<Shadow>& operation = at(id);
    operation.value = static_cast<double>(value);
    operation.error_bound = static_cast<double>(error_bound);
    operation.bits_lost = bits_lost(value, operation.exact);
    operation.digits = std::numeric_limits<T>::digits;
    double lost_before = 0;
    for (const OperationId x : operation.operands) {
      if (x != unrecorded)
        lost_before = std::max(lost_before, bits_lost(static_cast<T>(at(x).value), at(x).exact));
    }
    operation.bits_lost_here = operation.bits_lost - lost_before;
  }
  void name(const char* name, const std::vector<OperationId>& components) {
    names.push_back({name, components, current_step()});
  }
  [[nodiscard]] const Operation<Shadow>& at(OperationId id) const {
    return operations.at(static_cast<std::size_t>(id));
  }
  [[nodiscard]] Operation<Shadow>& at(OperationId id) { return operations.at(static_cast<std::size_t>(id)); }

 private:
  [[nodiscard]] std::ptrdiff_t current_step() const { return static_cast<std::ptrdiff_t>(steps.size()) - 1; }

  static inline thread_local Recording* active_ = nullptr;
  Recording* outer_;
};

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
