#pragma once
/// \file
/// A line that a program writes in reply to a case.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "case/json/text.hpp"
#include "subjects/outcome.hpp"

namespace rayproof::program {

/// A line of the answer format, read in two steps: whose answer it is, and then what it says.
class ReplyLine {
 public:
  /// Throws a Refusal where the line is no JSON object. It must outlive the reply.
  explicit ReplyLine(std::string_view line);

  /// The number of the case; nothing where there is none, or something else stands there.
  [[nodiscard]] std::optional<std::uint64_t> id() const;

  /// What it says of the case: nonsense where a field has the wrong type or contradicts another.
  [[nodiscard]] Outcome outcome(const Case& one) const;

 private:
  std::string_view line_;
  json::Document document_;
};

/// The number behind "id": in a line that is no JSON; nothing where there is none.
[[nodiscard]] std::optional<std::uint64_t> id_in_text(std::string_view line);

/// The beginning of a line as a sentence quotes it.
[[nodiscard]] std::string excerpt(std::string_view line);

}  // namespace rayproof::program
