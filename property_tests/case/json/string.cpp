#include <fmt/format.h>

#include <iterator>

#include "case/json/scanner.hpp"
#include "case/json/text.hpp"

namespace rayproof::json {
namespace {

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
