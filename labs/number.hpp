#pragma once
/// \file
/// What stands in place of double where rayproof lab explain compiles an answer: the library's recorded
/// number, which also keeps the exact value along the same path, and the line on which it was computed.

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <compare>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <rayproof/arithmetics/recorded.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace rayproof::lab {

/// 320 bits, and an exponent that no product of doubles leaves.
using Shadow = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<320, boost::multiprecision::digit_base_2, void, std::int32_t,
                                         -100000, 100000>,
    boost::multiprecision::et_off>;
using Traced = Recorded<double, Shadow>;

/// The name of the student's file, which the program that compiles it defines.
extern const char* const answer_file;

/// The line on which each operation of the active recording was done.
inline std::vector<unsigned>& lines() {
  static std::vector<unsigned> of_operation;
  return of_operation;
}

struct number;

/// A number or vector beside the line where it is handed to an operator or function.
template <class Value>
struct Placed {
  Value value;
  unsigned line;
  // NOLINTNEXTLINE(google-explicit-constructor): so that the place of an operand is that of its operation
  template <class Given>
  requires std::is_convertible_v<Given, Value> Placed(const Given& given, unsigned where = __builtin_LINE(),
                                                      const char* file = __builtin_FILE())
      : value(given), line(std::string_view(file).ends_with(answer_file) ? where : 0) {}
  Placed(const Value& given, unsigned where, int /*by hand*/) : value(given), line(where) {}
};

struct number {
  Traced traced{};

  number() = default;
  template <class Plain>
  requires std::is_arithmetic_v<Plain> number(Plain plain) : traced(plain) {}
  number(const Traced& result, unsigned line) : traced(result) {
    lines().resize(static_cast<std::size_t>(traced.id) + 1, 0);
    lines().back() = line;
  }
  template <class Plain>
  requires std::is_arithmetic_v<Plain>
  explicit operator Plain() const { return static_cast<Plain>(traced.value()); }

  using Given = Placed<number>;
  friend number operator-(const Given& x) { return {-x.value.traced, x.line}; }
  friend number operator+(const Given& x) { return x.value; }
  friend number operator+(const Given& x, const Given& y) {
    return {x.value.traced + y.value.traced, x.line};
  }
  friend number operator-(const Given& x, const Given& y) {
    return {x.value.traced - y.value.traced, x.line};
  }
  friend number operator*(const Given& x, const Given& y) {
    return {x.value.traced * y.value.traced, x.line};
  }
  friend number operator/(const Given& x, const Given& y) {
    return {x.value.traced / y.value.traced, x.line};
  }
  friend number& operator+=(number& x, const Given& y) { return x = {x.traced + y.value.traced, y.line}; }
  friend number& operator-=(number& x, const Given& y) { return x = {x.traced - y.value.traced, y.line}; }
  friend number& operator*=(number& x, const Given& y) { return x = {x.traced * y.value.traced, y.line}; }
  friend number& operator/=(number& x, const Given& y) { return x = {x.traced / y.value.traced, y.line}; }
  friend bool operator==(const Given& x, const Given& y) {
    return x.value.traced.value() == y.value.traced.value();
  }
  friend std::partial_ordering operator<=>(const Given& x, const Given& y) {
    return x.value.traced.value() <=> y.value.traced.value();
  }
};
using Given = Placed<number>;

inline number sqrt(const Given& x) { return {sqrt(x.value.traced), x.line}; }
inline number abs(const Given& x) { return {abs(x.value.traced), x.line}; }
inline number fabs(const Given& x) { return {abs(x.value.traced), x.line}; }
inline number copysign(const Given& x, const Given& y) {
  return {copysign(x.value.traced, y.value.traced), x.line};
}
inline number fma(const Given& x, const Given& y, const Given& z) {
  return {fma(x.value.traced, y.value.traced, z.value.traced), x.line};
}
inline number hypot(const Given& x, const Given& y) {
  return sqrt(Given(Given(x * x, x.line, 0) + Given(y * y, x.line, 0), x.line, 0));
}
inline number pow(const Given& x, int n) {
  number power = 1;
  for (int i = 0; i < std::abs(n); ++i) power = Given(power, x.line, 0) * x;
  return n < 0 ? Given(1, x.line, 0) / Given(power, x.line, 0) : power;
}
inline bool isnan(const number& x) { return std::isnan(x.traced.value()); }
inline bool isinf(const number& x) { return std::isinf(x.traced.value()); }
inline bool isfinite(const number& x) { return std::isfinite(x.traced.value()); }
inline bool signbit(const number& x) { return std::signbit(x.traced.value()); }
inline number fmin(const number& x, const number& y) { return isnan(x) || y < x ? y : x; }
inline number fmax(const number& x, const number& y) { return isnan(x) || x < y ? y : x; }
inline number min(const number& x, const number& y) { return y < x ? y : x; }
inline number max(const number& x, const number& y) { return x < y ? y : x; }

/// GLM's vectors as far as the labs use them.
template <int n>
struct TracedVector {
  std::array<number, n> parts{};
  number &x = parts[0], &y = parts[1], &z = parts[n - 1];

  TracedVector() = default;
  TracedVector(const TracedVector& other) : parts(other.parts) {}
  TracedVector& operator=(const TracedVector& other) {
    parts = other.parts;
    return *this;
  }
  explicit TracedVector(const number& all) { parts.fill(all); }
  TracedVector(const number& a, const number& b) requires(n == 2) : parts{a, b} {}
  TracedVector(const number& a, const number& b, const number& c) requires(n == 3) : parts{a, b, c} {}
  number& operator[](int i) { return parts.at(static_cast<std::size_t>(i)); }
  const number& operator[](int i) const { return parts.at(static_cast<std::size_t>(i)); }

  using Here = Placed<TracedVector>;
  template <class Function>
  friend TracedVector each(Function function, const Here& a, const Here& b) {
    TracedVector made;
    for (int i = 0; i < n; ++i)
      made[i] = function(Given(a.value[i], a.line, 0), Given(b.value[i], a.line, 0));
    return made;
  }
  friend TracedVector operator-(const Here& a) {
    return each([](const auto& x, const auto&) { return -x; }, a, a);
  }
  friend TracedVector operator+(const Here& a, const Here& b) { return each(std::plus<>(), a, b); }
  friend TracedVector operator-(const Here& a, const Here& b) { return each(std::minus<>(), a, b); }
  friend TracedVector operator*(const Here& a, const Here& b) { return each(std::multiplies<>(), a, b); }
  friend TracedVector operator/(const Here& a, const Here& b) { return each(std::divides<>(), a, b); }
  friend TracedVector operator*(const Given& s, const Here& a) {
    return each(std::multiplies<>(), {TracedVector(s.value), s.line, 0}, a);
  }
  friend TracedVector operator*(const Here& a, const Given& s) {
    return each(std::multiplies<>(), a, {TracedVector(s.value), s.line, 0});
  }
  friend TracedVector operator/(const Here& a, const Given& s) {
    return each(std::divides<>(), a, {TracedVector(s.value), s.line, 0});
  }
  friend TracedVector& operator+=(TracedVector& a, const Here& b) {
    return a = each(std::plus<>(), {a, b.line, 0}, b);
  }
  friend TracedVector& operator-=(TracedVector& a, const Here& b) {
    return a = each(std::minus<>(), {a, b.line, 0}, b);
  }
  friend TracedVector& operator*=(TracedVector& a, const Given& s) { return a = Here(a, s.line, 0) * s; }
  friend TracedVector& operator/=(TracedVector& a, const Given& s) { return a = Here(a, s.line, 0) / s; }
  friend bool operator==(const TracedVector& a, const TracedVector& b) { return a.parts == b.parts; }

  friend number dot(const Here& a, const Here& b) {
    number sum = Given(a.value[0], a.line, 0) * Given(b.value[0], a.line, 0);
    for (int i = 1; i < n; ++i)
      sum = Given(sum, a.line, 0) +
            Given(Given(a.value[i], a.line, 0) * Given(b.value[i], a.line, 0), a.line, 0);
    return sum;
  }
  friend number length(const Here& a) { return sqrt(Given(dot(a, a), a.line, 0)); }
  friend number distance(const Here& a, const Here& b) { return length(Here(a - b, a.line, 0)); }
  friend TracedVector normalize(const Here& a) { return a / Given(length(a), a.line, 0); }
  friend TracedVector abs(const Here& a) {
    return each([](const auto& x, const auto&) { return abs(x); }, a, a);
  }
  friend TracedVector min(const Here& a, const Here& b) {
    return each([](const auto& x, const auto& y) { return y.value < x.value ? y.value : x.value; }, a, b);
  }
  friend TracedVector max(const Here& a, const Here& b) {
    return each([](const auto& x, const auto& y) { return x.value < y.value ? y.value : x.value; }, a, b);
  }
};
using vec2 = TracedVector<2>;
using vec3 = TracedVector<3>;

inline vec3 cross(const Placed<vec3>& a, const Placed<vec3>& b) {
  const auto at = [&](const number& x) { return Given(x, a.line, 0); };
  const auto part = [&](int i, int j) {
    return at(at(a.value[i]) * at(b.value[j])) - at(at(a.value[j]) * at(b.value[i]));
  };
  return {part(1, 2), part(2, 0), part(0, 1)};
}

/// Runs the answer on a case, and writes for each line of its file the number computed there that lost most:
/// line, value, exact value, bits lost, and its place in the order of operations.
template <class Function>
int report(Function function) {
  Recording<Shadow> tape;
  function();
  std::map<unsigned, OperationId> worst;
  for (std::size_t i = 0; i < tape.operations.size() && i < lines().size(); ++i) {
    const unsigned line = lines()[i];
    if (line == 0 || tape.operations[i].op == Operator::constant) continue;
    const auto [at, is_new] = worst.try_emplace(line, static_cast<OperationId>(i));
    if (!is_new && tape.operations[i].bits_lost >= tape.at(at->second).bits_lost)
      at->second = static_cast<OperationId>(i);
  }
  for (const auto& [line, id] : worst) {
    const Operation<Shadow>& one = tape.at(id);
    std::printf("%u %.17g %s %.1f %td\n", line, one.value, one.exact.str(17).c_str(), one.bits_lost, id);
  }
  return 0;
}

}  // namespace rayproof::lab

template <>
class std::numeric_limits<rayproof::lab::number> : public std::numeric_limits<double> {};
