#pragma once
/// \file
/// What the user of any code expects of it: the contract of a subject that brings none.

#include <rayproof/method/contract.hpp>
#include <string>

namespace rayproof {

/// The bounds that the plain textbook methods of the topic keep (Möller–Trumbore, the quadratic formula on
/// the sphere's coefficients, slabs, even and odd crossings, stable roots), widened for other orders of the
/// same operations; the domain is the one that all of them share. Throws std::logic_error for no topic.
[[nodiscard]] Contract default_contract(const std::string& topic);

/// Whether the textbook's formula loses digits with the distance of a shape that the best plain methods keep
/// from any distance.
[[nodiscard]] bool loses_digits_from_afar(std::string_view topic);

}  // namespace rayproof
