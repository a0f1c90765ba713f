#pragma once
/// \file
/// What a program on trial says of a case, and how that is written.

#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "case/answer.hpp"

namespace rayproof {

/// Thrown by a function that does not answer a case at all: it is counted as `unsupported`, never judged.
class Unsupported : public std::runtime_error {
 public:
  explicit Unsupported(const std::string& why = "unsupported") : std::runtime_error(why) {}
};

namespace answering {

/// One reply. What is empty is not written, and what is not written is not judged.
struct FunctionReply {
  bool is_unsupported = false;
  std::string error{};
  std::optional<bool> is_hit{};
  bool lists_hits = false;     ///< `hits` is to be written, empty or not
  std::vector<double> hits{};  ///< of a ray; the roots of a quadratic
  std::optional<glm::dvec3> point{}, normal{}, barycentric{};
  std::optional<Position> position{};
  std::optional<RootKind> kind{};

  /// Back to empty; the list keeps its memory.
  void clear() {
    std::vector<double> list = std::move(hits);
    list.clear();
    *this = {};
    hits = std::move(list);
  }
};

/// The shortest JSON that reads back as exactly x; the case format's strings where x is not finite.
inline void append_number(std::string& out, double x) {
  if (!std::isfinite(x)) {
    out += std::isnan(x) ? "\"nan\"" : x > 0 ? "\"inf\"" : "\"-inf\"";
    return;
  }
  char digits[32];
  out.append(digits, std::to_chars(digits, digits + sizeof digits, x).ptr);
}

/// `, "name": [x, y, z]`.
inline void append_vector(std::string& out, std::string_view name, const glm::dvec3& v) {
  out.append(", \"").append(name).append("\": [");
  for (int i = 0; i < 3; ++i) {
    if (i > 0) out += ", ";
    append_number(out, v[i]);
  }
  out += ']';
}

/// Text as a JSON string; what JSON has no plain letter for becomes a blank.
inline void append_string(std::string& out, std::string_view text) {
  out += '"';
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  out += '"';
}

/// A list of numbers: [{"t": 4}, {"t": 6}] where each has a name, else [4, 6].
inline void append_list(std::string& out, const std::vector<double>& numbers, std::string_view name) {
  out += '[';
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0) out += ", ";
    if (!name.empty()) out.append("{\"").append(name).append("\": ");
    append_number(out, numbers[i]);
    if (!name.empty()) out += '}';
  }
  out += ']';
}

/// The reply as a line, its newline included.
inline void append_reply(std::string& out, std::string_view id, const FunctionReply& reply,
                         bool is_quadratic) {
  out.append("{\"id\": ").append(id.empty() ? "null" : id);
  if (!reply.error.empty()) {
    append_string(out += ", \"error\": ", reply.error);
  } else if (reply.is_unsupported) {
    out += ", \"unsupported\": true";
  } else {
    if (reply.is_hit && !is_quadratic)
      out += *reply.is_hit ? ", \"verdict\": \"hit\"" : ", \"verdict\": \"miss\"";
    if (reply.kind) out.append(", \"kind\": \"").append(name_of(*reply.kind)) += '"';
    if (reply.position) out.append(", \"position\": \"").append(name_of(*reply.position)) += '"';
    if (reply.lists_hits) {
      out += is_quadratic ? ", \"x\": " : ", \"hits\": ";
      append_list(out, reply.hits, is_quadratic ? "" : "t");
    }
    if (reply.point) append_vector(out, "point", *reply.point);
    if (reply.normal) append_vector(out, "normal", *reply.normal);
    if (reply.barycentric) append_vector(out, "barycentric", *reply.barycentric);
  }
  out += "}\n";
}

}  // namespace answering
}  // namespace rayproof
