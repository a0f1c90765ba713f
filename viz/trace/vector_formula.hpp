#pragma once
/// \file
/// The formulas of a vector's components, read back as one formula of vectors.

#include <functional>
#include <string>
#include <vector>

namespace rayproof::viz {

/// "o − C" of "o.x − C.x", "o.y − C.y" and "o.z − C.z"; "a × b" of the components of a cross product; empty
/// where the components have no formula in common.
[[nodiscard]] std::string vector_formula(const std::vector<std::string>& components);

/// The formula with each name replaced by what `number_of` says of it; names of which it says nothing stay.
[[nodiscard]] std::string put_in(const std::string& formula,
                                 const std::function<std::string(const std::string& name)>& number_of);

}  // namespace rayproof::viz
