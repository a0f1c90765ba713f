#include "case/json/text.hpp"

#include <fmt/format.h>

#include "case/json/number_text.hpp"
#include "case/json/ordered.hpp"
#include "case/json/scanner.hpp"
#include "case/shape_format.hpp"

namespace rayproof::json {
namespace {

/// Builds a document from the scanner's tokens, with a stack of its own in place of recursion.
class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text), scanner_(text) { document_.reserve(64); }

  Document parse() {
    if (text_.starts_with("\xEF\xBB\xBF")) scanner_.refuse("no byte order mark");
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
    const std::string_view rest = text_.substr(scanner_.position());
    open_.push_back(document_.size());
    document_.push_back({Kind::null, rest, key_, std::string_view::npos});
    key_ = {};
    try {
      const Kind kind = document_.back().kind = scanner_.kind_of_next();
      if (kind == Kind::array || kind == Kind::object) return scanner_.skip(1);
      scanner_.skip_scalar(kind);
    } catch (const Refusal&) {
      refuse_infinity(rest);
      throw;
    }
    close();
  }

  /// Moves to the next child of the innermost open container and says so, or closes the container.
  bool next_child() {
    const bool is_object = document_[open_.back()].kind == Kind::object;
    const bool is_empty = document_.size() == open_.back() + 1;
    scanner_.skip_blanks();
    if (scanner_.take(is_object ? '}' : ']')) {
      close();
      return false;
    }
    if (!is_empty && !scanner_.take(',')) scanner_.refuse(is_object ? "',' or '}'" : "',' or ']'");
    scanner_.skip_blanks();
    if (is_object) read_key();
    return true;
  }

  void read_key() {
    key_ = text_.substr(scanner_.position());
    scanner_.skip_string("a field's name in quotes");
    end_here(key_);
    scanner_.skip_blanks();
    if (!scanner_.take(':')) scanner_.refuse("':'");
    scanner_.skip_blanks();
  }

  void close() {
    Node& node = document_[open_.back()];
    node.end = document_.size();
    end_here(node.text);
    open_.pop_back();
  }

  /// Cuts a part that runs on to the end of the text where the scanner stands.
  void end_here(std::string_view& part) const { part.remove_suffix(text_.size() - scanner_.position()); }

  /// Python's json and others write infinities and NaN as words, which are not JSON. Refuses such a word by
  /// the name of its field.
  void refuse_infinity(std::string_view rest) const {
    const std::string_view word = rest.substr(0, rest.find_first_of(",]} \t\r\n"));
    const std::string_view spelling = case_spelling(word);
    if (spelling.empty()) return;
    const std::string path = path_to(document_, document_.size() - 1);
    throw Refusal(
        path, fmt::format("the line is not JSON: {} is {}, {}", path.empty() ? "the case" : path, word,
                          spelling == "nan" ? "which no number of a case may be"
                                            : fmt::format("which is written \"{}\", a string", spelling)));
  }

  std::string_view text_;
  Scanner scanner_;
  Document document_;
  std::vector<std::size_t> open_;  ///< outermost first; the last is the value that is being read
  std::string_view key_{};         ///< of the value about to be read
};

}  // namespace

Document parse(std::string_view text) { return Parser(text).parse(); }

std::string path_to(const Document& document, std::size_t node) {
  std::string path;
  for (std::size_t container = 0; container != node;) {
    std::size_t child = container + 1, position = 0;
    for (; document[child].end <= node; child = document[child].end) ++position;
    if (document[container].kind == Kind::object)
      append_member(path, unquote(document[child].key));
    else
      path += fmt::format("[{}]", position);
    container = child;
  }
  return path;
}

void append_member(std::string& path, std::string_view name) {
  if (!path.empty()) path += '.';
  path += name;
}

std::string unquote(std::string_view quoted) {
  const bool is_plain = quoted.find('\\') == std::string_view::npos;
  return is_plain ? std::string(quoted.substr(1, quoted.size() - 2)) : read_json(quoted).get<std::string>();
}

std::string quote(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < 0x20) {
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      if (c == '"' || c == '\\') out += '\\';
      out += c;
    }
  }
  return out + '"';
}

}  // namespace rayproof::json
