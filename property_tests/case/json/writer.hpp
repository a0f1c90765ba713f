#pragma once
/// \file
/// Puts JSON together on one line, in the layout of the case format's examples.

#include <array>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "case/json/number_text.hpp"
#include "case/json/text.hpp"

namespace rayproof {

/// Appends value after value; `member` and `element` put the commas.
class JsonWriter {
 public:
  JsonWriter() { out_.reserve(256); }

  JsonWriter& open(char bracket) {
    out_ += bracket;
    is_first_ = true;
    return *this;
  }
  void close(char bracket) {
    out_ += bracket;
    is_first_ = false;
  }

  /// Begins the next element of the open array.
  JsonWriter& element() {
    if (!is_first_) out_ += ", ";
    is_first_ = false;
    return *this;
  }
  /// Begins the next member of the open object; `name` needs no escapes.
  JsonWriter& member(std::string_view name) {
    element();
    out_.append(1, '"').append(name).append("\": ");
    return *this;
  }

  void raw(std::string_view json) { out_ += json; }
  void string(std::string_view text) { out_ += json::quote(text); }
  void hex(double x) { append_hex(out_, x); }

  /// A number of an answer: reads back, as a double, as exactly this.
  void number(double x) { append_number(out_, x); }
  void number(const glm::dvec3& v) {
    list(std::array{v.x, v.y, v.z}, [this](double x) { number(x); });
  }

  /// A value of a case: reads back, rounded to the case's precision, as exactly this.
  void input(double x, Precision precision) { append_number(out_, x, precision); }
  void input(bool yes, Precision /*precision*/) { raw(yes ? "true" : "false"); }
  void input(const glm::dvec3& v, Precision precision) { input(std::array{v.x, v.y, v.z}, precision); }
  void input(const Vec2<double>& v, Precision precision) { input(std::array{v.x, v.y}, precision); }
  template <class T, std::size_t N>
  void input(const std::array<T, N>& values, Precision precision) {
    list(values, [&](const T& value) { input(value, precision); });
  }
  template <class T>
  void input(const std::vector<T>& values, Precision precision) {
    list(values, [&](const T& value) { input(value, precision); });
  }

  [[nodiscard]] std::string take() { return std::move(out_); }

 private:
  template <class Values, class Write>
  void list(const Values& values, Write&& write) {
    open('[');
    for (const auto& value : values) {
      element();
      write(value);
    }
    close(']');
  }

  std::string out_{};
  bool is_first_ = true;
};

}  // namespace rayproof
