#include "case/json_text.hpp"

#include <fmt/format.h>

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

void append_utf8(std::string& out, unsigned code) {
  const auto put = [&out](unsigned byte) { out.push_back(static_cast<char>(byte)); };
  const auto put_tail = [&](unsigned shift) { put(0x80U | ((code >> shift) & 0x3FU)); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xC0U | (code >> 6));
    put_tail(0);
  } else if (code < 0x10000) {
    put(0xE0U | (code >> 12));
    put_tail(6);
    put_tail(0);
  } else {
    put(0xF0U | (code >> 18));
    put_tail(12);
    put_tail(6);
    put_tail(0);
  }
}

/// The character of a one-letter escape such as \n.
char unescaped(char letter) {
  switch (letter) {
    case 'b':
      return '\b';
    case 'f':
      return '\f';
    case 'n':
      return '\n';
    case 'r':
      return '\r';
    case 't':
      return '\t';
    default:
      return letter;
  }
}

}  // namespace

Document parse(std::string_view text) { return Parser(text).parse(); }

std::string unquote(std::string_view quoted) {
  const std::string_view inside = quoted.substr(1, quoted.size() - 2);
  std::string out;
  for (std::size_t i = 0; i < inside.size(); ++i) {
    if (inside[i] != '\\') {
      out.push_back(inside[i]);
    } else if (inside[++i] != 'u') {
      out.push_back(unescaped(inside[i]));
    } else {
      unsigned code = hex4(inside.substr(i + 1, 4));
      i += 4;
      if (is_high_surrogate(code)) {  // the scanner has seen to it that its partner follows
        code = 0x10000 + ((code - 0xD800) << 10) + (hex4(inside.substr(i + 3, 4)) - 0xDC00);
        i += 6;
      }
      append_utf8(out, code);
    }
  }
  return out;
}

std::string quote(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out.push_back('\\');
      out.push_back(c);
    } else if (static_cast<unsigned char>(c) < 0x20) {
      fmt::format_to(std::back_inserter(out), "\\u{:04x}", static_cast<unsigned>(c));
    } else {
      out.push_back(c);
    }
  }
  out.push_back('"');
  return out;
}

}  // namespace rayproof::json
