#pragma once
/// \file
/// Answers a lab's questions by a function: reads a line of arguments as a JSON list on standard input,
/// writes
/// {"result": …}, until the input is closed. What the function itself prints goes to standard error.
///
///     int main() { return rayproof::answer_questions(ray); }

#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <glm/glm.hpp>
#include <iostream>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace rayproof {

/// Reads numbers and lists of them from a line of JSON, which is taken to be right.
class QuestionReader {
 public:
  explicit QuestionReader(const std::string& line) : at_(line.c_str()) { skip(); }

  template <class T>
  T read() {
    if constexpr (std::is_arithmetic_v<T>) {
      char* end = nullptr;
      const double number = std::strtod(at_, &end);
      at_ = end;
      skip_blanks();
      return static_cast<T>(number);
    } else {
      return read_list(static_cast<T*>(nullptr));
    }
  }

 private:
  void skip_blanks() {
    while (*at_ == ' ' || *at_ == ',') ++at_;
  }
  void skip() {  // a bracket, of either kind
    if (*at_ != '\0') ++at_;
    skip_blanks();
  }
  glm::dvec3 read_list(glm::dvec3*) {
    skip();
    glm::dvec3 v;
    for (int i = 0; i < 3; ++i) v[i] = read<double>();
    skip();
    return v;
  }
  template <class T>
  std::vector<T> read_list(std::vector<T>*) {
    skip();
    std::vector<T> list;
    while (*at_ != ']' && *at_ != '\0') list.push_back(read<T>());
    skip();
    return list;
  }

  const char* at_;
};

inline std::string json_of(double x) {
  if (x != x) return "NaN";
  std::array<char, 32> digits{};
  std::snprintf(digits.data(), digits.size(), "%.17g", x);
  return x - x == 0 ? digits.data() : x > 0 ? "Infinity" : "-Infinity";
}
inline std::string json_of(bool b) { return b ? "true" : "false"; }
inline std::string json_of(int i) { return std::to_string(i); }

template <class List>
std::string json_of(const List& list);
inline std::string json_of(const glm::dvec3& v) { return json_of(std::array{v.x, v.y, v.z}); }
template <class T>
std::string json_of(const std::optional<T>& value) {
  return value ? json_of(*value) : "null";
}
template <class List>
std::string json_of(const List& list) {
  std::string text;
  for (const auto& one : list) text += (text.empty() ? "" : ", ") + json_of(one);
  return "[" + text + "]";
}

template <class Result, class... Parameters>
int answer_all(const std::function<Result(Parameters...)>& function) {
  std::FILE* answers = fdopen(dup(STDOUT_FILENO), "w");
  if (answers == nullptr || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) return EXIT_FAILURE;
  for (std::string line; std::getline(std::cin, line);) {
    QuestionReader reader(line);
    const std::tuple<std::decay_t<Parameters>...> arguments{reader.read<std::decay_t<Parameters>>()...};
    std::fprintf(answers, "{\"result\": %s}\n", json_of(std::apply(function, arguments)).c_str());
    std::fflush(answers);
  }
  std::fclose(answers);
  return EXIT_SUCCESS;
}

template <class Function>
int answer_questions(Function function) {
  return answer_all(std::function(function));
}

}  // namespace rayproof
