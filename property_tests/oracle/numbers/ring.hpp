#pragma once
/// \file
/// The ring that the oracle computes in: exact numbers, or estimates of them where these are enough.
///
/// A judgement is made with estimates first, which takes a quarter of the time. Nearly always they are
/// certain of every sign and of enough digits; where they are not, a `Doubt` is noted, and all is done again
/// exactly. The formulas are the same and stand once.
///
/// Source: H. Brönnimann, C. Burnikel, S. Pion, "Interval Arithmetic Yields Efficient Dynamic Filters for
/// Computational Geometry", 2001.

#include <CGAL/Mpzf.h>

#include <concepts>
#include <memory>
#include <new>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "oracle/numbers/estimate.hpp"

namespace rayproof::oracle {

/// Dyadic numbers with exact + - * and sign; no division. Every finite double is one, subnormals included.
using Exact = CGAL::Mpzf;

/// That an estimate was not enough, noted for the thread. Whatever is computed after that is of no use, and
/// whoever computes by estimates asks at the end. An exception would cost more than most judgements.
class Doubt {
 public:
  static void clear() { is_noted_ = false; }
  static void note() { is_noted_ = true; }
  [[nodiscard]] static bool is_noted() { return is_noted_; }

 private:
  static inline constinit thread_local bool is_noted_ = false;
};

/// As long as one lives, its thread makes estimates.
class Filtering {
 public:
  Filtering() { is_on = true; }
  ~Filtering() { is_on = false; }
  Filtering(const Filtering&) = delete;
  Filtering& operator=(const Filtering&) = delete;

  static inline constinit thread_local bool is_on = false;
};

/// Whether all that is made from here on will be done again exactly.
[[nodiscard]] inline bool is_in_vain() { return Filtering::is_on && Doubt::is_noted(); }

/// An exact number, or an estimate of it.
class Ring {
 public:
  Ring(double x = 0) {  // NOLINT: every double is in the ring
    if (Filtering::is_on)
      put(Estimate(x));
    else
      put([x] { return Exact(x); });
  }
  Ring(const Ring& other) { take(other); }
  Ring(Ring&& other) noexcept { take(std::move(other)); }
  Ring& operator=(const Ring& other) {
    if (this == &other) return *this;
    drop();
    take(other);
    return *this;
  }
  Ring& operator=(Ring&& other) noexcept {
    if (this == &other) return *this;
    drop();
    take(std::move(other));
    return *this;
  }
  ~Ring() { drop(); }

  [[nodiscard]] bool is_exact() const { return is_exact_; }
  [[nodiscard]] const Exact& exact() const { return exact_; }
  [[nodiscard]] const Estimate& estimate() const { return estimate_; }

  friend Ring operator-(const Ring& x) { return x.is_exact_ ? negative(x) : Ring(-x.estimate_); }
  friend Ring operator+(const Ring& x, const Ring& y) {
    return are_estimates(x, y) ? Ring(x.estimate_ + y.estimate_) : sum(x, y);
  }
  friend Ring operator-(const Ring& x, const Ring& y) {
    return are_estimates(x, y) ? Ring(x.estimate_ - y.estimate_) : difference(x, y);
  }
  friend Ring operator*(const Ring& x, const Ring& y) {
    return are_estimates(x, y) ? Ring(x.estimate_ * y.estimate_) : product(x, y);
  }

 private:
  explicit Ring(const Estimate& x) { put(x); }
  template <class Make>
  requires std::is_invocable_r_v<Exact, Make>
  explicit Ring(const Make& make) { put(make); }

  static bool are_estimates(const Ring& x, const Ring& y) { return !x.is_exact_ && !y.is_exact_; }
  static void both_exact(const Ring& x, const Ring& y) {
    if (x.is_exact_ != y.is_exact_)
      throw std::logic_error("an exact number meets an estimate, of another judgement");
  }
  [[gnu::noinline]] static Ring negative(const Ring& x) {
    return Ring([&] { return -x.exact_; });
  }
  [[gnu::noinline]] static Ring sum(const Ring& x, const Ring& y) {
    both_exact(x, y);
    return Ring([&] { return x.exact_ + y.exact_; });
  }
  [[gnu::noinline]] static Ring difference(const Ring& x, const Ring& y) {
    both_exact(x, y);
    return Ring([&] { return x.exact_ - y.exact_; });
  }
  [[gnu::noinline]] static Ring product(const Ring& x, const Ring& y) {
    both_exact(x, y);
    return Ring([&] { return x.exact_ * y.exact_; });
  }

  void put(const Estimate& x) {
    std::construct_at(&estimate_, x);
    is_exact_ = false;
  }
  /// Makes the number where it is to stand: to move one takes as long as to copy it.
  template <class Make>
  void put(const Make& make) {
    ::new (static_cast<void*>(&exact_)) Exact(make());
    is_exact_ = true;
  }
  template <class Other>
  void take(Other&& other) {
    if (other.is_exact_)
      put([&] { return Exact(std::forward<Other>(other).exact_); });
    else
      put(other.estimate_);
  }
  void drop() {
    if (is_exact_) std::destroy_at(&exact_);
  }

  union {
    Estimate estimate_;
    Exact exact_;
  };
  bool is_exact_;
};

}  // namespace rayproof::oracle
