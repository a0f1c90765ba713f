#pragma once
/// \file
/// What a search for leaks came to: a table, a page with a picture of each kind, and cases.

#include "leaks/search.hpp"

namespace rayproof::leaks {

/// A line for each subject and precision: rays, leaks by target, double hits; at most 120 columns wide.
[[nodiscard]] std::string text_table(const Result& result);

/// One sentence for each subject that is held to it (`is_held_to`) and leaks, hits twice or gives no answer;
/// none where all is well.
[[nodiscard]] std::vector<std::string> broken_promises(const Result& result);

/// The cases of all losses that are kept, one triangle a line.
[[nodiscard]] std::string case_lines(const Result& result);

/// All figures as one JSON object.
[[nodiscard]] std::string json_text(const ClosedMesh& mesh, const LeakSettings& settings,
                                    const Result& result);

/// A self-contained page: the table, and of each subject the first leak and the first double hit, seen along
/// the ray.
[[nodiscard]] std::string html_page(const ClosedMesh& mesh, const LeakSettings& settings,
                                    const Result& result);

/// The triangles about the target as the ray sees them, in SVG.
[[nodiscard]] std::string picture_of(const Loss& loss);

}  // namespace rayproof::leaks
