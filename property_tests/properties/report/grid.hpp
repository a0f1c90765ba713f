#pragma once
#include <string>
#include <vector>

namespace rayproof {

/// A table in plain text: columns as wide as their widest cell.
class Grid {
 public:
  /// The number of blanks between two columns.
  explicit Grid(std::size_t gap = 2) : gap_(gap) {}

  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }

  /// The rows, each ending in a newline.
  [[nodiscard]] std::string rows() const;

  /// The same with a rule under the first row.
  [[nodiscard]] std::string text() const;

 private:
  std::size_t gap_;
  std::vector<std::vector<std::string>> rows_{};
};

}  // namespace rayproof
