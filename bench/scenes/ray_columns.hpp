#pragma once
/// \file
/// Rays in columns, as batches take them.

#include <array>
#include <rayproof/batch.hpp>
#include <vector>

namespace rayproof::report {

/// The coordinates of origins and directions, a column each.
class RayColumns {
 public:
  void add(const Ray<float>& ray) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      columns_[axis].push_back(ray.origin[static_cast<int>(axis)]);
      columns_[axis + 3].push_back(ray.direction[static_cast<int>(axis)]);
    }
  }
  [[nodiscard]] std::size_t size() const { return columns_[0].size(); }

  /// `size` of them, from the given one on.
  [[nodiscard]] RayBatch<float> part(std::size_t from, std::size_t size) const {
    const auto& [x, y, z, dx, dy, dz] = columns_;
    const auto part_of = [=](const auto& column) { return std::span(column).subspan(from, size); };
    return {{part_of(x), part_of(y), part_of(z)}, {part_of(dx), part_of(dy), part_of(dz)}};
  }

 private:
  std::array<std::vector<float>, 6> columns_;
};

}  // namespace rayproof::report
