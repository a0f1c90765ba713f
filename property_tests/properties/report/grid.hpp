#pragma once
#include <string>
#include <vector>

namespace rayproof {

/// The cells of a table, row by row.
using Rows = std::vector<std::vector<std::string>>;

/// A table in plain text: columns as wide as their widest cell and `gap` blanks apart, each row ending in a
/// newline, with a rule under the first row where one is wanted. That row has a cell for every column.
[[nodiscard]] std::string in_columns(const Rows& rows, std::size_t gap = 2, bool has_rule = true);

}  // namespace rayproof
