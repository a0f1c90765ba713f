#pragma once
/// \file
/// Exact quotients: where a line meets something flat, and what follows from that.

#include <utility>

#include "oracle/numbers/exact.hpp"

namespace rayproof::oracle {

/// numerator / denominator, exactly; the denominator is made positive.
template <class R>
class QuotientOf {
 public:
  using Over = R;

  QuotientOf(double x) : numerator_(x), denominator_(1.0) {}  // NOLINT: every double is a quotient
  /// `denominator` is not 0.
  QuotientOf(R numerator, R denominator)
      : numerator_(std::move(numerator)), denominator_(std::move(denominator)) {
    if (sign(denominator_) > 0) return;
    numerator_ = -numerator_;
    denominator_ = -denominator_;
  }

  [[nodiscard]] const R& numerator() const { return numerator_; }
  [[nodiscard]] const R& denominator() const { return denominator_; }

  /// The sign of (quotient - x), exactly.
  [[nodiscard]] int compare(const R& x) const { return sign(numerator_ - x * denominator_); }
  [[nodiscard]] int compare(const QuotientOf& other) const {
    return sign(numerator_ * other.denominator_ - other.numerator_ * denominator_);
  }

  /// quotient - x, an error, to one part in 2^29.
  [[nodiscard]] SizeOf<R> minus(double x) const {
    return roughly(numerator_ - R(x) * denominator_) / approximate(denominator_);
  }

  /// The quotient to one part in 2^60.
  [[nodiscard]] SizeOf<R> estimate() const { return approximate(numerator_) / approximate(denominator_); }

  /// offset + slope·quotient.
  [[nodiscard]] QuotientOf affine_image(const R& offset, const R& slope) const {
    return {offset * denominator_ + slope * numerator_, denominator_};
  }

 private:
  R numerator_;
  R denominator_;
};
using Quotient = QuotientOf<Ring>;

}  // namespace rayproof::oracle
