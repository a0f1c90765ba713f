#pragma once
/// \file
/// `rayproof draw --heat`: a method's errors over a surface.

#include <string>

#include "viz/programs/report_case.hpp"

namespace rayproof::viz {

/// Aims a ray from the case's origin at every small part of its shape's surface, asks the method and the
/// oracle, and writes the errors as colours on it. Throws WrongCommand for a case that has no such picture,
/// std::runtime_error where the file can't be written.
void write_heat_map(const CaseReport& report, const std::string& path);

}  // namespace rayproof::viz
