#include "viz/trace/numbers.hpp"

#include <mpfr.h>

namespace rayproof::viz {
namespace {

constexpr mpfr_prec_t significant_bits = 320;

}  // namespace

/// MPFR's view of a shadow, which holds the digits.
struct Inside {
  static_assert(sizeof(Shadow::digits_) * 8 == significant_bits);

  mpfr_t number;

  explicit Inside(const Shadow& x) {
    // MPFR takes no const digits, and writes none of those that it reads.
    auto* digits = const_cast<std::uint64_t*>(x.digits_);
    mpfr_custom_init_set(number, x.kind_, x.exponent_, significant_bits, digits);
  }
  operator mpfr_srcptr() const { return number; }

  /// A shadow that is still to be put.
  static Shadow unset() { return Shadow(Shadow::Unset{}); }
  /// Makes x what `compute(result)` sets.
  template <class Compute>
  static void put(Shadow& x, Compute&& compute) {
    mpfr_t result;
    mpfr_custom_init_set(result, MPFR_ZERO_KIND, 0, significant_bits, x.digits_);
    compute(result);
    x.kind_ = mpfr_custom_get_kind(result);
    x.exponent_ = mpfr_custom_get_exp(result);
  }
};

namespace {

/// function(result, x…, to nearest) of MPFR.
template <class Function, class... Arguments>
Shadow computed(Function function, const Arguments&... x) {
  Shadow result = Inside::unset();
  Inside::put(result, [&](mpfr_ptr to) { function(to, x..., MPFR_RNDN); });
  return result;
}

}  // namespace

Shadow::Shadow(Exactly exactly) {
  Inside::put(*this, [&](mpfr_ptr to) { mpfr_set_d(to, exactly.value, MPFR_RNDN); });
}

Shadow::operator double() const { return mpfr_get_d(Inside(*this), MPFR_RNDN); }
Shadow::operator float() const { return mpfr_get_flt(Inside(*this), MPFR_RNDN); }

Shadow operator-(const Shadow& x) { return computed(mpfr_neg, Inside(x)); }
Shadow operator+(const Shadow& x, const Shadow& y) { return computed(mpfr_add, Inside(x), Inside(y)); }
Shadow operator-(const Shadow& x, const Shadow& y) { return computed(mpfr_sub, Inside(x), Inside(y)); }
Shadow operator*(const Shadow& x, const Shadow& y) { return computed(mpfr_mul, Inside(x), Inside(y)); }
Shadow operator/(const Shadow& x, const Shadow& y) { return computed(mpfr_div, Inside(x), Inside(y)); }

bool operator==(const Shadow& x, const Shadow& y) { return mpfr_equal_p(Inside(x), Inside(y)) != 0; }
std::partial_ordering operator<=>(const Shadow& x, const Shadow& y) {
  const Inside one(x), other(y);
  if (mpfr_unordered_p(one, other) != 0) return std::partial_ordering::unordered;
  return mpfr_cmp(one, other) <=> 0;
}

bool isfinite(const Shadow& x) { return mpfr_number_p(Inside(x).number) != 0; }
bool isinf(const Shadow& x) { return mpfr_inf_p(Inside(x).number) != 0; }
bool isnan(const Shadow& x) { return mpfr_nan_p(Inside(x).number) != 0; }

Shadow abs(const Shadow& x) { return computed(mpfr_abs, Inside(x)); }
Shadow fma(const Shadow& x, const Shadow& y, const Shadow& z) {
  return computed(mpfr_fma, Inside(x), Inside(y), Inside(z));
}
Shadow sqrt(const Shadow& x) { return computed(mpfr_sqrt, Inside(x)); }
Shadow pow(const Shadow& x, int n) { return computed(mpfr_pow_si, Inside(x), n); }
Shadow ldexp(const Shadow& x, int e) { return computed(mpfr_mul_2si, Inside(x), e); }
Shadow frexp(const Shadow& x, int* e) {
  mpfr_exp_t exponent = 0;
  Shadow significand = Inside::unset();
  Inside::put(significand, [&](mpfr_ptr to) { mpfr_frexp(&exponent, to, Inside(x), MPFR_RNDN); });
  *e = static_cast<int>(exponent);
  return significand;
}

std::string in_digits(const Shadow& x, int digits, bool has_final_zeros) {
  // The digits, and at most a sign, a point, zeros behind it, "e+" and the exponent.
  std::string text(static_cast<std::size_t>(digits) + 24, '\0');
  const char* const format = has_final_zeros ? "%#.*Rg" : "%.*Rg";
  const int length = mpfr_snprintf(text.data(), text.size(), format, digits, Inside(x).number);
  text.resize(static_cast<std::size_t>(length));
  if (text.ends_with('.')) text.pop_back();
  return text;
}

}  // namespace rayproof::viz
