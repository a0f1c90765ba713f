#pragma once
/// \file
/// A binary tree over boxes: which ones may a ray meet at all?

#include <array>
#include <cstdint>
#include <rayproof/objects/ray_against_boxes.hpp>
#include <vector>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::objects {

/// Boxes halved again and again where the surface area heuristic says, then in the middle.
///
/// Source: I. Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007 (bins).
class BoundsTree {
 public:
  explicit BoundsTree(const std::vector<Bounds>& boxes);

  /// Calls `meet(i)` for each box i that the ray meets, mostly the nearer ones first. It gives back the
  /// t beyond which nothing matters any more: the nearest hit's so far, or NaN to end the search.
  template <class Meet>
  void visit(const RayAgainstBoxes& ray, double t_max, Meet&& meet) const {
    std::array<Pending, deepest> stack{};
    std::size_t depth = 0;
    const auto push = [&](double t, const Branch& branch) {
      if (t <= t_max) stack[depth++] = {t, branch};
    };
    if (!order_.empty()) push(ray.entry(bounds_, t_max), root_);
    while (depth > 0) {
      const auto [t, branch] = stack[--depth];
      if (!(t <= t_max)) continue;
      if (branch.count == 0) {
        const TreeNode& node = nodes_[branch.first];
        const std::array<double, 2> entry{ray.entry(node.boxes[0], t_max), ray.entry(node.boxes[1], t_max)};
        const std::size_t near = entry[1] < entry[0] ? 1 : 0;
        push(entry[1 - near], node.branches[1 - near]);
        push(entry[near], node.branches[near]);
        continue;
      }
      for (std::uint32_t i = branch.first; i < branch.first + branch.count; ++i)
        if (ray.entry(boxes_[i], t_max) <= t_max) t_max = meet(order_[i]);
    }
  }

  /// The least box that holds all.
  [[nodiscard]] const Bounds& bounds() const { return bounds_; }

 private:
  /// A box in half the memory, rounded outwards.
  struct FloatBounds {
    glm::vec3 low, high;
    explicit FloatBounds(const Bounds& bounds);
  };
  /// Either `count` boxes, from `first` on in the order, or, where count is 0, the node `first`.
  struct Branch {
    std::uint32_t first = 0, count = 0;
  };
  /// Both halves of what it splits, in one line of the processor's cache.
  struct alignas(64) TreeNode {
    std::array<FloatBounds, 2> boxes;
    std::array<Branch, 2> branches;
  };
  /// What is still to be looked into, and where the ray enters it.
  struct Pending {
    double t;
    Branch branch;
  };
  /// Halves by area down to here, and then in the middle, which needs at most 32 levels more.
  static constexpr std::size_t deepest_by_area = 31;
  static constexpr std::size_t deepest = 2 + deepest_by_area + 32;

  struct Building;

  std::vector<std::uint32_t> order_{};
  std::vector<FloatBounds> boxes_{};  ///< in the order's order
  std::vector<TreeNode> nodes_{};
  Bounds bounds_{};
  Branch root_{};
};

}  // namespace rayproof::objects

#include <rayproof/rounding/as_before.hpp>
