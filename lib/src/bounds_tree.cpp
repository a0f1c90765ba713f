/// \file
/// How a tree over boxes is built.

#include <algorithm>
#include <numeric>
#include <rayproof/objects/bounds_tree.hpp>

namespace rayproof::objects {
// Named, since functions of BoundsTree hold these: in one unit with other sources, g++ warns of nameless
// ones.
namespace splitting {

constexpr std::uint32_t leaf_size = 4;
constexpr std::size_t bin_count = 16;
/// What it costs to look at a node's two boxes, in boxes of a leaf, each with its object.
constexpr double cost_of_a_node = 0.5;

/// Boxes whose centres are near each other along an axis.
struct Bin {
  Bounds bounds{};
  std::uint32_t count = 0;

  void add(const Bin& other) {
    bounds = bounds.around(other.bounds);
    count += other.count;
  }
  /// Half the surface's area times the number of boxes.
  [[nodiscard]] double cost() const {
    if (count == 0) return 0;
    const glm::dvec3 size = bounds.high - bounds.low;
    return count * (size.x * size.y + size.y * size.z + size.z * size.x);
  }
};

/// Twice the centre, which orders boxes as the centre does.
glm::dvec3 centre_of(const Bounds& box) { return box.low + box.high; }

/// The axis along which a box is longest.
int longest_axis(const Bounds& box) {
  const glm::dvec3 size = box.high - box.low;
  return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

/// Which bin a box belongs to.
class Binning {
 public:
  explicit Binning(const Bounds& centres)
      : axis_(longest_axis(centres)),
        low_(centres.low[axis_]),
        per_length_(static_cast<double>(bin_count) * (1 - 0x1p-40) / (centres.high[axis_] - low_)) {}

  /// Whether the centres differ, by more than what can be divided by.
  [[nodiscard]] bool is_sound() const { return per_length_ < HUGE_VAL; }
  [[nodiscard]] std::size_t operator()(const Bounds& box) const {
    return static_cast<std::size_t>((centre_of(box)[axis_] - low_) * per_length_);
  }

 private:
  int axis_;
  double low_, per_length_;
};

/// After which bin to split, at the least sum of both sides' costs; `bin_count` where one leaf costs less.
std::size_t best_split(const std::array<Bin, bin_count>& bins) {
  std::array<double, bin_count> cost_above{};
  Bin above;
  for (std::size_t i = bin_count - 1; i > 0; --i) {
    above.add(bins[i]);
    cost_above[i - 1] = above.cost();
  }
  above.add(bins[0]);
  std::size_t best = bin_count;
  double least = above.count <= leaf_size ? above.cost() * (1 - cost_of_a_node / above.count) : HUGE_VAL;
  Bin below;
  for (std::size_t i = 0; i + 1 < bin_count; ++i) {
    below.add(bins[i]);
    const bool is_split = below.count > 0 && below.count < above.count;
    if (!is_split || !(below.cost() + cost_above[i] < least)) continue;
    least = below.cost() + cost_above[i];
    best = i;
  }
  return best;
}

}  // namespace splitting
using namespace splitting;

BoundsTree::FloatBounds::FloatBounds(const Bounds& bounds) : low(bounds.low), high(bounds.high) {
  for (int axis = 0; axis < 3; ++axis) {
    if (low[axis] > bounds.low[axis]) low[axis] = std::nextafter(low[axis], -HUGE_VALF);
    if (high[axis] < bounds.high[axis]) high[axis] = std::nextafter(high[axis], HUGE_VALF);
  }
}

/// Splits the boxes of a tree, which are put into its order on the way.
struct BoundsTree::Building {
  const std::vector<Bounds>& boxes;
  std::vector<std::uint32_t>& order;
  std::vector<TreeNode>& nodes;

  [[nodiscard]] Bounds around(std::uint32_t begin, std::uint32_t end) const {
    Bounds all;
    for (std::uint32_t i = begin; i < end; ++i) all = all.around(boxes[order[i]]);
    return all;
  }

  Branch branch_over(std::uint32_t begin, std::uint32_t end, std::size_t depth) {
    std::uint32_t middle = depth < deepest_by_area ? split_by_area(begin, end) : end;
    if (middle == end && end - begin > leaf_size) middle = split_in_the_middle(begin, end);
    if (middle == end) return {begin, end - begin};
    const auto index = static_cast<std::uint32_t>(nodes.size());
    nodes.push_back({{FloatBounds(around(begin, middle)), FloatBounds(around(middle, end))}, {}});
    const Branch below = branch_over(begin, middle, depth + 1);
    const Branch above = branch_over(middle, end, depth + 1);
    nodes[index].branches = {below, above};
    return {index, 0};
  }

  /// `end` where it is no gain.
  std::uint32_t split_by_area(std::uint32_t begin, std::uint32_t end) {
    Bounds centres;
    for (std::uint32_t i = begin; i < end; ++i) {
      const glm::dvec3 centre = centre_of(boxes[order[i]]);
      centres = centres.around({centre, centre});
    }
    const Binning bin_of(centres);
    if (!bin_of.is_sound()) return end;
    std::array<Bin, bin_count> bins{};
    for (std::uint32_t i = begin; i < end; ++i) bins[bin_of(boxes[order[i]])].add({boxes[order[i]], 1});
    const std::size_t last = best_split(bins);
    if (last == bin_count) return end;
    const auto middle = std::partition(order.begin() + begin, order.begin() + end,
                                       [&](std::uint32_t i) { return bin_of(boxes[i]) <= last; });
    return static_cast<std::uint32_t>(middle - order.begin());
  }

  std::uint32_t split_in_the_middle(std::uint32_t begin, std::uint32_t end) {
    const int axis = longest_axis(around(begin, end));
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(order.begin() + begin, order.begin() + middle, order.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                       return centre_of(boxes[a])[axis] < centre_of(boxes[b])[axis];
                     });
    return middle;
  }
};

BoundsTree::BoundsTree(const std::vector<Bounds>& boxes) : order_(boxes.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  if (boxes.empty()) return;
  Building building{boxes, order_, nodes_};
  const auto size = static_cast<std::uint32_t>(boxes.size());
  bounds_ = building.around(0, size);
  root_ = building.branch_over(0, size, 0);
  boxes_.reserve(boxes.size());
  for (const std::uint32_t i : order_) boxes_.emplace_back(boxes[i]);
}

}  // namespace rayproof::objects
