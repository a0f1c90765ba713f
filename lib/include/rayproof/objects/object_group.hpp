#pragma once
/// \file
/// The objects of one shape in a list, and which of them a ray meets.

#include <algorithm>
#include <bit>
#include <cmath>
#include <rayproof/objects/kernels.hpp>
#include <rayproof/objects/listed_object.hpp>

namespace rayproof::objects {

/// Objects as blocks of numbers, for the kernels; and the place of each in its group.
template <class Problem, std::size_t count>
class ObjectBlocks {
  using T = typename Many<Problem>::Number;

 public:
  /// `numbers` are those of the shape, or of the shape and its space.
  void add(const std::array<T, count>& numbers, std::size_t place) {
    const std::size_t lane = places_.size() % lanes;
    if (lane == 0) numbers_.resize(numbers_.size() + count * lanes);
    // Lanes without an object repeat the last one, so that a kernel takes the same path for all.
    auto column = numbers_.end() - static_cast<std::ptrdiff_t>(count * lanes);
    for (const T& number : numbers) {
      std::fill(column + static_cast<std::ptrdiff_t>(lane), column + lanes, number);
      column += lanes;
    }
    places_.push_back(place);
  }

  /// Calls `meet(place)` for those that may hold the nearest hit, and puts the t it gives back into `t_max`:
  /// beyond that no hit matters any more. NaN ends the search. Hits that no kernel is sure of are met, too.
  template <class Kernel, class Meet>
  void visit(const Kernel& kernel, const Ray<T>& ray, T& t_max, const Meet& meet) const {
    constexpr std::size_t most = 32;
    T t[most * lanes];
    for (std::size_t from = 0; from < places_.size() && !std::isnan(t_max); from += most * lanes) {
      const std::size_t size = std::min(most * lanes, places_.size() - from);
      const LeastHit<T> least = kernel({numbers_.data() + from * count, (size + lanes - 1) / lanes, ray}, t);
      if (least.t < infinity<T> && least.t <= t_max) {
        const auto first = static_cast<std::size_t>(std::find(t, t + size, least.t) - t);
        t_max = meet(places_[from + first]);
      }
      if (!least.is_in_doubt) continue;
      for (std::size_t i = 0; i < size && !std::isnan(t_max); ++i)
        if (std::isnan(t[i])) t_max = meet(places_[from + i]);
    }
  }

 private:
  std::vector<T> numbers_{};
  std::vector<std::size_t> places_{};
};

/// All objects of a topic's shape, in the order in which they were added.
template <class Topic, template <class> class ShapeOf, std::floating_point T>
class ObjectGroup {
 public:
  using Shape = ShapeOf<T>;
  using Object = ListedObject<Topic, Shape, T>;

  void add(Object object) {
    if constexpr (has_columns<Topic>) add_numbers(object);
    is_any_in_world_ = is_any_in_world_ || object.space;
    objects_.push_back(std::move(object));
  }
  [[nodiscard]] const std::vector<Object>& objects() const { return objects_; }

  /// Calls `meet(object)` for those that may be hit first, by the method of `Choice`; see ObjectBlocks.
  template <class Choice, class Meet>
  void visit(const Ray<T>& ray, T& t_max, const Meet& meet) const {
    using Method = typename Choice::template method<Topic>;
    if constexpr (has_kernel<Method, Problem>) {
      if (objects_.size() >= fewest) {
        visit_in_packs<Method>(ray, t_max, meet);
        return;
      }
    }
    visit_one_by_one(t_max, meet, false);
  }

 private:
  using Problem = RayProblem<ShapeOf, T>;
  struct NoBlocks {};
  template <std::size_t count>
  using Blocks = std::conditional_t<has_columns<Topic>, ObjectBlocks<Problem, count>, NoBlocks>;
  static constexpr std::size_t shape_numbers = Many<Problem>::shape_numbers,
                               all_numbers = shape_numbers + Many<Problem>::space_numbers;
  /// A pack costs as much as two or three objects by themselves.
  static constexpr std::size_t fewest = 3;

  template <class Method, class Meet>
  void visit_in_packs(const Ray<T>& ray, T& t_max, const Meet& meet) const {
    const auto& kernel = std::get<ObjectKernel<Method, Problem>>(kernel_table(preferred_instruction_set()));
    const auto meet_at = [&](std::size_t place) { return meet(objects_[place]); };
    own_.visit(kernel.meet, ray, t_max, meet_at);
    if constexpr (has_kernel_in_world<Method, ShapeOf, T>)
      in_world_.visit(kernel.meet_in_world, ray, t_max, meet_at);
    else if (is_any_in_world_)
      visit_one_by_one(t_max, meet, true);
  }
  template <class Meet>
  void visit_one_by_one(T& t_max, const Meet& meet, bool only_in_world) const {
    for (const Object& object : objects_) {
      if (std::isnan(t_max)) return;
      if (object.space || !only_in_world) t_max = meet(object);
    }
  }

  void add_numbers(const Object& object) {
    const auto shape = std::bit_cast<std::array<T, shape_numbers>>(object.shape);
    if (!object.space) return own_.add(shape, objects_.size());
    const auto space = std::bit_cast<std::array<T, all_numbers - shape_numbers>>(*object.space);
    std::array<T, all_numbers> numbers;
    std::copy(space.begin(), space.end(), std::copy(shape.begin(), shape.end(), numbers.begin()));
    in_world_.add(numbers, objects_.size());
  }

  std::vector<Object> objects_{};
  bool is_any_in_world_ = false;
  Blocks<shape_numbers> own_{};
  Blocks<all_numbers> in_world_{};
};

/// A group for each shape of the topics.
template <class Topic, class T, template <class> class Shape>
auto groups_of(const RayTopic<Shape>* /*topic*/) -> std::tuple<ObjectGroup<Topic, Shape, T>>;
template <class Topic, class T>
auto groups_of(const void* /*no shape*/) -> std::tuple<>;
template <class T, class... Topics>
auto groups_of_all(TypeList<Topics...>)
    -> decltype(std::tuple_cat(groups_of<Topics, T>(static_cast<const Topics*>(nullptr))...));

/// Whether there is a group for the shape among these.
template <class Shape, class... Groups>
constexpr bool holds(const std::tuple<Groups...>* /*groups*/) {
  return (std::is_same_v<typename Groups::Shape, Shape> || ...);
}

}  // namespace rayproof::objects
