#pragma once
/// \file
/// JSON as it was written: a strict reader (RFC 8259) that keeps the text of every number and every id.
///
/// The case format defines numbers by their text: 1e999 rounds to infinity, and 16777217 to a float by way of
/// a double. Readers that turn numbers into doubles as they go have lost that text by the time it matters.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rayproof::json {

enum class Kind : std::uint8_t { null, boolean, number, string, array, object };

/// One value of a document.
struct Node {
  Kind kind = Kind::null;
  std::string_view text{};  ///< as written; a string with its quotes, an array or object with its brackets
  std::string_view key{};   ///< of a member of an object, with its quotes
  std::size_t end = 0;      ///< index of the first node after this one's descendants; beyond all while open
};

/// The values of one text in the order in which they begin, so that a container's first child is the node
/// after it and a child's next sibling is at its `end`. Flat, hence as deep as memory allows.
using Document = std::vector<Node>;

/// Reads one JSON text. Throws a Refusal that says what was expected at which byte. The document points into
/// `text`.
[[nodiscard]] Document parse(std::string_view text);

/// "ray.origin[1]": the path to a node from the first, empty for that. Also while the document is being read.
[[nodiscard]] std::string path_to(const Document& document, std::size_t node);

/// Makes an object's path its member's.
void append_member(std::string& path, std::string_view name);

/// What a string in quotes, already read by `parse`, stands for, in UTF-8.
[[nodiscard]] std::string unquote(std::string_view quoted);

/// A text in quotes: the JSON string that stands for `text`, which is UTF-8.
[[nodiscard]] std::string quote(std::string_view text);

}  // namespace rayproof::json
