#pragma once
/// \file
/// A formula as a source prints it, beside the right one.

#include "viz/walkthrough/lesson.hpp"

namespace rayproof::viz {

/// The stage of a method on the case, with only those steps that differ from `right`'s, then the steps of
/// `right` that differ from its.
[[nodiscard]] Stage stage_beside(const Case& one, const ReportCase& report_on, const std::string& method,
                                 const std::string& right);

}  // namespace rayproof::viz
