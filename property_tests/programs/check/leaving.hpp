#pragma once
/// \file
/// The part of rayproof check that leaves surfaces: a small search of what rayproof spawn searches at length.

#include "programs/check/options.hpp"
#include "properties/leaving/text.hpp"

namespace rayproof::check {

/// The search; nothing where the filters ask for single methods, properties or families, or for no shape that
/// a ray can leave.
[[nodiscard]] std::optional<leaving::SearchResult> leave_surfaces(
    const Settings& settings, const std::function<void(const std::string&, double)>& progress);

/// Prints what it came to and writes the failing rays to leaving.jsonl in the folder of the outputs; whether
/// what is proven holds.
[[nodiscard]] bool report_leaving(const Options& options, const leaving::SearchResult& result);

}  // namespace rayproof::check
