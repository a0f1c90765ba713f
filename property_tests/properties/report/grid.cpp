#include "properties/report/grid.hpp"

#include <algorithm>
#include <numeric>

namespace rayproof {

namespace {

/// How many columns a UTF-8 text takes, all its characters being one column wide.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

}  // namespace

std::string in_columns(const Rows& rows, std::size_t gap, bool has_rule) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const auto& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], width(row[c]));
  const std::size_t gaps = gap * (widths.size() - 1);
  const std::string rule(std::accumulate(widths.begin(), widths.end(), gaps), '-');
  std::string all;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c)
      line += row[c] + std::string(widths[c] - width(row[c]) + gap, ' ');
    all += line.erase(line.find_last_not_of(' ') + 1) + "\n";
    if (has_rule && &row == &rows.front()) all += rule + "\n";
  }
  return all;
}

}  // namespace rayproof
