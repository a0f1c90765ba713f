#pragma once
/// \file
/// Exact quotients: where a line meets something flat, and what follows from that.

#include <utility>

#include "oracle/numbers/exact.hpp"

namespace rayproof::oracle {

/// numerator / denominator, exactly; the denominator is made positive.
class Quotient {
 public:
  Quotient(double x) : numerator_(x), denominator_(1.0) {}  // NOLINT: every double is a quotient
  /// `denominator` is not 0.
  Quotient(Ring numerator, Ring denominator)
      : numerator_(std::move(numerator)), denominator_(std::move(denominator)) {
    if (sign(denominator_) > 0) return;
    numerator_ = -numerator_;
    denominator_ = -denominator_;
  }

  [[nodiscard]] const Ring& numerator() const { return numerator_; }
  [[nodiscard]] const Ring& denominator() const { return denominator_; }

  /// The sign of (quotient - x), exactly.
  [[nodiscard]] int compare(const Ring& x) const { return sign(numerator_ - x * denominator_); }
  [[nodiscard]] int compare(const Quotient& other) const {
    return sign(numerator_ * other.denominator_ - other.numerator_ * denominator_);
  }

  /// quotient - x, an error, to one part in 2^29.
  [[nodiscard]] Scaled minus(double x) const {
    return roughly(numerator_ - Ring(x) * denominator_) / approximate(denominator_);
  }

  /// The quotient to one part in 2^60.
  [[nodiscard]] Scaled estimate() const { return approximate(numerator_) / approximate(denominator_); }

  /// offset + slope·quotient.
  [[nodiscard]] Quotient affine_image(const Ring& offset, const Ring& slope) const {
    return {offset * denominator_ + slope * numerator_, denominator_};
  }

 private:
  Ring numerator_;
  Ring denominator_;
};

}  // namespace rayproof::oracle
