#pragma once
/// \file
/// Findings: a subject, a property, and the case that breaks it.

#include <string>
#include <string_view>

#include "properties/property.hpp"

namespace rayproof {

/// One broken property.
struct Finding {
  std::size_t number = 0;  ///< from 1: the line in the findings file of the run; 0 before they are in order
  const Subject* subject = nullptr;
  const Property* property = nullptr;
  std::string family{};  ///< where the case came from: a family's name, or "corpus"
  Case one{};
  Evidence evidence{};
  bool is_declared = false;  ///< the subject is known to break it, and says so
};

/// The finding as a line of JSON without its newline, as the case format says; the evidence's note is the
/// case's.
[[nodiscard]] std::string write_finding(const Finding& finding);

/// A line to be tested again: a finding, or a bare case, for which subject and property are
/// empty.
struct Replayed {
  std::string subject{};
  std::string property{};
  std::string command{};  ///< the shell line of a subject that is one
  Case one{};
};

/// Reads a finding or a case. Throws a Refusal.
[[nodiscard]] Replayed read_replayed(std::string_view line);

}  // namespace rayproof
