/// \file
/// A binary tree of boxes, halved at the middle object along the longest side.

#include <algorithm>
#include <array>
#include <numeric>

#include "viz/render/neighbourhood.hpp"

namespace rayproof::render {
namespace {

constexpr std::size_t leaf_size = 4;
/// Halving 2^32 objects goes no deeper than this.
constexpr std::size_t deepest = 64;

/// A box over objects [begin, end) of the order; its children are the next node and `second`, 0 for a leaf.
struct TreeNode {
  Bounds bounds{};
  std::uint32_t begin = 0, end = 0, second = 0;
};

class BoundsTree final : public Neighbourhood {
 public:
  explicit BoundsTree(ObjectBounds bounds) : bounds_(std::move(bounds)), order_(bounds_.boxes.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()));
  }

  void visit(const Ray<double>& ray, const Meet& meet) const override {
    double nearest = HUGE_VAL;
    for (const ObjectIndex object : bounds_.unbounded) nearest = meet(object);
    if (nodes_.empty()) return;
    const RayAgainstBoxes boxes(ray);
    std::array<std::uint32_t, deepest> stack{};
    std::size_t depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const TreeNode& node = nodes_[stack[--depth]];
      if (!boxes.entry(node.bounds, nearest)) continue;
      if (node.second != 0) {
        push_children(boxes, node, nearest, stack, depth);
        continue;
      }
      for (std::uint32_t i = node.begin; i < node.end; ++i) {
        if (boxes.entry(bounds_.boxes[order_[i]], nearest)) nearest = meet(bounds_.boxed[order_[i]]);
      }
    }
  }

 private:
  /// Puts the nearer child on top.
  void push_children(const RayAgainstBoxes& boxes, const TreeNode& node, double nearest,
                     std::array<std::uint32_t, deepest>& stack, std::size_t& depth) const {
    std::uint32_t near = static_cast<std::uint32_t>(&node - nodes_.data()) + 1, far = node.second;
    const auto first = boxes.entry(nodes_[near].bounds, nearest);
    const auto second = boxes.entry(nodes_[far].bounds, nearest);
    if (first && second && *second < *first) std::swap(near, far);
    if (first && second) stack[depth++] = far;
    if (first || second) stack[depth++] = first ? near : far;
  }

  std::uint32_t build(std::uint32_t begin, std::uint32_t end) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({bounds_.boxes[order_[begin]], begin, end, 0});
    for (std::uint32_t i = begin + 1; i < end; ++i)
      nodes_[index].bounds = nodes_[index].bounds.around(bounds_.boxes[order_[i]]);
    if (end - begin <= leaf_size) return index;
    const glm::dvec3 size = nodes_[index].bounds.high - nodes_[index].bounds.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t middle = begin + (end - begin) / 2;
    const auto twice_centre = [&](std::uint32_t i) {
      return bounds_.boxes[i].low[axis] + bounds_.boxes[i].high[axis];
    };
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) { return twice_centre(a) < twice_centre(b); });
    build(begin, middle);
    nodes_[index].second = build(middle, end);
    return index;
  }

  ObjectBounds bounds_;
  std::vector<std::uint32_t> order_;
  std::vector<TreeNode> nodes_{};
};

}  // namespace

ObjectBounds::ObjectBounds(const RenderScene& scene, double margin) {
  boxes.reserve(scene.objects.size());
  boxed.reserve(scene.objects.size());
  for (ObjectIndex i = 0; i < scene.objects.size(); ++i) {
    if (const auto box = bounds_of(scene.objects[i])) {
      boxes.push_back(margin > 0 ? box->grown(margin) : *box);
      boxed.push_back(i);
    } else {
      unbounded.push_back(i);
    }
  }
}

std::unique_ptr<Neighbourhood> bounds_tree(ObjectBounds bounds) {
  return std::make_unique<BoundsTree>(std::move(bounds));
}

}  // namespace rayproof::render
