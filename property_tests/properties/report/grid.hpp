#pragma once
#include <string>
#include <vector>

namespace rayproof {

/// A table in plain text: columns as wide as their widest cell, a rule under the first row.
class Grid {
 public:
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }

  /// Every line ends in a newline.
  [[nodiscard]] std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_{};
};

}  // namespace rayproof
