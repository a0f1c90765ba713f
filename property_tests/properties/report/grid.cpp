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

std::string Grid::rows() const {
  std::vector<std::size_t> widths;
  for (const auto& row : rows_) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], width(row[c]));
  }
  std::string all;
  for (const auto& row : rows_) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c)
      line += row[c] + std::string(widths[c] - width(row[c]) + gap_, ' ');
    line.erase(line.find_last_not_of(' ') + 1);
    all += line + "\n";
  }
  return all;
}

std::string Grid::text() const {
  std::string all = rows();
  std::size_t widest = 0;
  for (std::size_t begin = 0; begin < all.size();) {
    const std::size_t end = all.find('\n', begin);
    widest = std::max(widest, width(all.substr(begin, end - begin)));
    begin = end + 1;
  }
  all.insert(all.find('\n') + 1, std::string(widest, '-') + "\n");
  return all;
}

}  // namespace rayproof
