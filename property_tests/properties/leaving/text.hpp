#pragma once
/// \file
/// What a search for false hits came to, as text and as JSON.

#include "properties/leaving/search.hpp"

namespace rayproof::leaving {

/// A line for each strategy: rays, false hits, solids skipped, offsets; at most 120 columns wide.
[[nodiscard]] std::string text_table(const SearchResult& result);
/// The same in a line for each strategy: offsets, median and largest, relative to the size of the scene.
[[nodiscard]] std::string text_brief(const SearchResult& result);
/// A line for each strategy and shape: false hits in float and in double.
[[nodiscard]] std::string text_shapes(const SearchResult& result);
/// For each size of scene, of the rays that a fixed or a relative offset starts rightly, the share of which
/// the proven offset is at least ten times smaller; empty where these were not asked side by side.
[[nodiscard]] std::string text_tenfold(const SearchResult& result);
/// The failures, each with its smallest case.
[[nodiscard]] std::string text_failures(const SearchResult& result);
/// The failing rays as cases, one a line.
[[nodiscard]] std::string case_lines(const SearchResult& result);
/// What the proven strategies promise and do not keep, and what a strategy is known to do and did not.
[[nodiscard]] std::vector<std::string> broken_promises(const SearchResult& result);
/// One JSON object: for each strategy, precision and decade of the scene's size, the counts and offsets.
[[nodiscard]] std::string json_text(const SearchSettings& settings, const SearchResult& result);

}  // namespace rayproof::leaving
