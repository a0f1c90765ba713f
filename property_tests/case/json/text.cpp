#include "case/json/text.hpp"

#include <fmt/format.h>

#include "case/json/number_text.hpp"
#include "case/json/scanner.hpp"
#include "case/shape_format.hpp"

namespace rayproof::json {
namespace {

/// Builds a document from the scanner's tokens, with a stack of its own in place of recursion.
class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text), scanner_(text) { document_.reserve(64); }

  Document parse() {
    scanner_.skip_blanks();
    do {
      begin_value();
      while (!open_.empty() && !next_child()) {
      }
    } while (!open_.empty());
    scanner_.skip_blanks();
    if (!scanner_.at_end()) scanner_.refuse("the end of the line");
    return std::move(document_);
  }

 private:
  /// Reads a scalar whole, or the opening bracket of a container.
  void begin_value() {
    const std::size_t start = scanner_.position();
    document_.push_back({Kind::null, {}, key_, document_.size() + 1});
    key_ = {};
    try {
      const Kind kind = scanner_.kind_of_next();
      document_.back().kind = kind;
      if (kind != Kind::array && kind != Kind::object) {
        scanner_.skip_scalar(kind);
        document_.back().text = scanner_.text_from(start);
        return;
      }
    } catch (const Refusal&) {
      refuse_infinity(start);
      throw;
    }
    scanner_.skip(1);
    open_.push_back({document_.size() - 1, start, true});
  }

  /// Moves to the next child of the innermost open container and says so, or closes the container.
  bool next_child() {
    Open& open = open_.back();
    const bool is_object = document_[open.node].kind == Kind::object;
    const char closing = is_object ? '}' : ']';
    scanner_.skip_blanks();
    if (scanner_.take(closing)) {
      close();
      return false;
    }
    if (!open.is_empty && !scanner_.take(',')) scanner_.refuse(is_object ? "',' or '}'" : "',' or ']'");
    open.is_empty = false;
    scanner_.skip_blanks();
    if (is_object) read_key();
    return true;
  }

  void read_key() {
    const std::size_t start = scanner_.position();
    scanner_.skip_string("a field's name in quotes");
    key_ = scanner_.text_from(start);
    scanner_.skip_blanks();
    if (!scanner_.take(':')) scanner_.refuse("':'");
    scanner_.skip_blanks();
  }

  void close() {
    Node& node = document_[open_.back().node];
    node.end = document_.size();
    node.text = scanner_.text_from(open_.back().start);
    open_.pop_back();
  }

  /// Python's json and others write infinities and NaN as words, which are not JSON. Refuses such a word by
  /// the name of its field.
  void refuse_infinity(std::size_t start) const {
    const std::string_view rest = text_.substr(start);
    const std::string_view word = rest.substr(0, rest.find_first_of(",]} \t\r\n"));
    const std::string_view spelling = case_spelling(word);
    if (spelling.empty()) return;
    const std::string path = path_of_last();
    throw Refusal(
        path, fmt::format("the line is not JSON: {} is {}, {}", path.empty() ? "the case" : path, word,
                          spelling == "nan" ? "which no number of a case may be"
                                            : fmt::format("which is written \"{}\", a string", spelling)));
  }

  /// "ray.origin[1]": the way to the value that is being read.
  [[nodiscard]] std::string path_of_last() const {
    std::string path;
    for (std::size_t depth = 0; depth < open_.size(); ++depth) {
      const std::size_t container = open_[depth].node;
      const std::size_t child = depth + 1 < open_.size() ? open_[depth + 1].node : document_.size() - 1;
      if (document_[container].kind == Kind::object) {
        path += (path.empty() ? "" : ".") + unquote(document_[child].key);
      } else {
        std::size_t position = 0;
        for (std::size_t i = container + 1; i < child; i = document_[i].end) ++position;
        path += fmt::format("[{}]", position);
      }
    }
    return path;
  }

  struct Open {
    std::size_t node;
    std::size_t start;  ///< of its text
    bool is_empty;      ///< no child read yet
  };

  std::string_view text_;
  Scanner scanner_;
  Document document_;
  std::vector<Open> open_;
  std::string_view key_{};  ///< of the value about to be read
};

}  // namespace

Document parse(std::string_view text) { return Parser(text).parse(); }

}  // namespace rayproof::json
