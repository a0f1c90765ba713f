#include "properties/report/grid.hpp"

#include <algorithm>

namespace rayproof {

namespace {

/// How many columns a UTF-8 text takes, all its characters being one column wide.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

}  // namespace

std::string Grid::text() const {
  std::vector<std::size_t> widths;
  for (const auto& row : rows_) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], width(row[c]));
  }
  std::string all;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    std::string line;
    for (std::size_t c = 0; c < rows_[r].size(); ++c)
      line += rows_[r][c] + std::string(widths[c] - width(rows_[r][c]) + 2, ' ');
    line.erase(line.find_last_not_of(' ') + 1);
    all += line + "\n";
    if (r > 0) continue;
    std::size_t total = 0;
    for (const std::size_t w : widths) total += w + 2;
    all.append(std::max<std::size_t>(total, 2) - 2, '-').append("\n");
  }
  return all;
}

}  // namespace rayproof
