#include "case/json_text.hpp"

#include "case/json_scanner.hpp"
#include "case/shape_format.hpp"

namespace rayproof::json {
namespace {

/// Builds a document from the scanner's tokens, with a stack of its own in place of recursion.
class Parser {
 public:
  explicit Parser(std::string_view text) : scanner_(text) { document_.reserve(64); }

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
    const Kind kind = scanner_.kind_of_next();
    document_.push_back({kind, {}, key_, document_.size() + 1});
    key_ = {};
    if (kind != Kind::array && kind != Kind::object) {
      scanner_.skip_scalar(kind);
      document_.back().text = scanner_.text_from(start);
      return;
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

  struct Open {
    std::size_t node;
    std::size_t start;  ///< of its text
    bool is_empty;      ///< no child read yet
  };

  Scanner scanner_;
  Document document_;
  std::vector<Open> open_;
  std::string_view key_{};  ///< of the value about to be read
};

}  // namespace

Document parse(std::string_view text) { return Parser(text).parse(); }

}  // namespace rayproof::json
