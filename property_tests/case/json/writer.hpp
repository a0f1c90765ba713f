#pragma once
/// \file
/// Puts a JSON object together on one line, in the layout of the case format's examples.

#include <string>
#include <string_view>

#include "case/each_number.hpp"
#include "case/json/number_text.hpp"
#include "case/json/text.hpp"

namespace rayproof {

/// Appends value after value; `member` and `element` put the commas.
class JsonWriter {
 public:
  JsonWriter() {
    out_.reserve(256);
    open('{');
  }

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

  /// A number, or a vector, matrix or list of them: reads back, rounded to the precision, as exactly this.
  /// The numbers of an answer are doubles, whatever its case's precision.
  template <class V>
  void value(const V& value, Precision precision = Precision::float64) {
    if constexpr (std::is_same_v<V, bool>) {
      raw(value ? "true" : "false");
    } else if constexpr (std::is_same_v<V, double>) {
      append_number(out_, value, precision);
    } else {
      open('[');
      each_element(value, [&](const auto& part) { element().value(part, precision); });
      close(']');
    }
  }

  /// The object, closed.
  [[nodiscard]] std::string take() {
    close('}');
    return std::move(out_);
  }

 private:
  std::string out_{};
  bool is_first_ = true;
};

}  // namespace rayproof
