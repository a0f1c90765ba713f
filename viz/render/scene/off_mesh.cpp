#include "viz/render/scene/scene_reader.hpp"

#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <string>

namespace rayproof::render {
namespace {

class OffReader {
 public:
  explicit OffReader(const std::filesystem::path& file) : file_(file), in_(file) {
    if (!in_) throw UnreadableFile(fmt::format("the file {} can't be read", file.string()));
  }

  std::vector<Triangle<double>> read() {
    next_line();
    if (take_word() != "OFF") refuse("must begin with OFF");
    if (rest_.empty()) next_line();
    const std::size_t vertex_count = take_count("vertices"), face_count = take_count("faces");
    for (std::size_t i = 0; i < vertex_count; ++i) {
      next_line();
      // One after another: the order of a call's arguments is nobody's promise.
      const double x = take_number(), y = take_number(), z = take_number();
      vertices_.emplace_back(x, y, z);
    }
    for (std::size_t i = 0; i < face_count; ++i) {
      next_line();
      add_face();
    }
    return std::move(triangles_);
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw UnreadableFile(fmt::format("{}: line {} {}", file_.string(), line_, what));
  }

  /// The next line that says something.
  void next_line() {
    do {
      ++line_;
      if (!std::getline(in_, text_)) refuse("is missing: the file ends before it");
      rest_ = std::string_view(text_).substr(0, text_.find('#'));
      skip_blanks();
    } while (rest_.empty());
  }

  void skip_blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r"), rest_.size())); }

  std::string_view take_word() {
    const std::string_view word = rest_.substr(0, rest_.find_first_of(" \t\r"));
    rest_.remove_prefix(word.size());
    skip_blanks();
    return word;
  }

  template <class Number>
  Number take(const char* expected) {
    std::string_view word = take_word();
    const std::string_view whole = word;
    if (word.starts_with('+')) word.remove_prefix(1);
    Number number{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size())
      refuse(fmt::format("must have {}, not \"{}\"", expected, whole));
    return number;
  }
  double take_number() { return take<double>("3 numbers"); }
  std::size_t take_count(const char* of) {
    return take<std::size_t>(fmt::format("a number of {}", of).c_str());
  }

  void add_face() {
    const auto corners = take<std::size_t>("a number of corners");
    if (corners < 3) refuse(fmt::format("must have 3 corners or more, not {}", corners));
    const glm::dvec3 first = take_vertex();
    glm::dvec3 before = take_vertex();
    for (std::size_t i = 2; i < corners; ++i) {
      const glm::dvec3 next = take_vertex();
      triangles_.push_back({first, before, next});
      before = next;
    }
  }

  glm::dvec3 take_vertex() {
    const auto index = take<std::size_t>("the indices of its corners");
    if (index >= vertices_.size())
      refuse(fmt::format("must name one of the {} vertices, from 0, not {}", vertices_.size(), index));
    return vertices_[index];
  }

  std::filesystem::path file_;
  std::ifstream in_;
  std::string text_{};
  std::string_view rest_{};
  std::size_t line_ = 0;
  std::vector<glm::dvec3> vertices_{};
  std::vector<Triangle<double>> triangles_{};
};

}  // namespace

std::vector<Triangle<double>> read_off(const std::filesystem::path& file) { return OffReader(file).read(); }

}  // namespace rayproof::render
