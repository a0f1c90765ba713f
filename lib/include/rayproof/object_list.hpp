#pragma once
/// \file
/// Objects of any shapes, and what a ray meets among them: the nearest hit, any, or all.
///
/// \code
/// rayproof::ObjectList<float> objects;
/// objects.add(rayproof::Sphere<float>{{0, 0, 5}, 1});
/// objects.add(rayproof::Box<float>{{-1, -1, 8}, {1, 1, 9}});
/// const auto hit = objects.nearest({{0, 0, 0}, {0, 0, 1}});
/// assert(hit && hit->index == 0 && hit->t == 4 && hit->normal.z == -1);
/// \endcode
///
/// The ray is tested against all objects: against spheres, triangles, boxes and parallelepipeds in packs, as
/// many at once as the processor has lanes, against the others one after the other. Of many an ObjectTree
/// asks only the few near the ray (object_tree.hpp).

#include <rayproof/objects/many_rays.hpp>
#include <rayproof/objects/object_group.hpp>
#include <rayproof/objects/search.hpp>

namespace rayproof {

/// The method of a shape's topic that an ObjectList asks.
struct PlainMethods {
  template <class Topic>
  using method = typename Topic::Plain;
};
/// No verdict is wrong, and each t is the exact one rounded once, under a matrix too.
struct ExactMethods {
  template <class Topic>
  using method = typename Topic::Exact;
};

/// See the head of the file.
template <std::floating_point T, class Choice = PlainMethods>
class ObjectList {
 public:
  /// Adds an object; its index is returned.
  template <class Shape>
  std::size_t add(Shape shape) {
    return add_at(std::move(shape), std::nullopt);
  }
  /// The same under an affine object-to-world matrix (last row 0 0 0 1). What a singular one makes is missed,
  /// and so may be what one makes whose determinant over- or underflows (object_space).
  template <class Shape>
  std::size_t add(Shape shape, const glm::mat<4, 4, T>& object_to_world) {
    return add_at(std::move(shape), object_space<T>(object_to_world));
  }
  [[nodiscard]] std::size_t size() const { return size_; }

  /// The nearest hit in the ray's interval; of several at one t, that of the object added first.
  [[nodiscard]] std::optional<HitRecord<T>> nearest(const Ray<T>& ray) const {
    return objects::nearest_of<Choice>(ray, near(ray));
  }
  /// The nearest hit of each of many rays, bit for bit as above: its t, infinity for a miss, and the object's
  /// index, `no_object` for a miss, and for a hit whose t overflows. Both arrays are as long as the batch,
  /// which has no matrix. In packs of rays, one object after the other: of up to some ten objects many times
  /// faster than ray by ray.
  void nearest(const RayBatch<T>& rays, std::span<T> t, std::span<std::uint32_t> index,
               InstructionSet set = preferred_instruction_set()) const {
    objects::nearest_of_many<Choice>(rays, t, index, set, [this](const auto& meet) { this->for_each(meet); });
  }
  /// Whether anything is hit in the ray's interval: what a shadow ray asks.
  [[nodiscard]] bool any(const Ray<T>& ray) const { return objects::any_of<Choice>(ray, near(ray)); }
  /// Every hit in the ray's interval, ascending; of a solid both, of a tangent one. Asks one object after the
  /// other.
  [[nodiscard]] std::vector<HitRecord<T>> all(const Ray<T>& ray) const {
    return objects::all_of<Choice>(ray, [this](const auto& meet) { this->for_each(meet); });
  }

  /// Calls `meet(object)` for each object in the order of the shapes, until that gives NaN.
  template <class Meet>
  void for_each(const Meet& meet) const {
    const auto is_over = [&](const auto& object) { return std::isnan(meet(object)); };
    std::apply([&](const auto&... groups) { (std::ranges::any_of(groups.objects(), is_over) || ...); },
               groups_);
  }
  /// Calls `meet(object)` for the n-th object in that order, and gives back its answer; n counts from 0.
  template <class Meet>
  [[nodiscard]] T meet_nth(std::size_t n, const Meet& meet) const {
    T answer{};
    const auto is_in = [&](const auto& group) {
      const std::size_t size = group.objects().size();
      const bool is_here = n < size;
      if (is_here)
        answer = meet(group.objects()[n]);
      else
        n -= size;
      return is_here;
    };
    std::apply([&](const auto&... groups) { (is_in(groups) || ...); }, groups_);
    return answer;
  }

 private:
  using Groups = decltype(objects::groups_of_all<T>(Topics{}));

  template <class Shape>
  std::size_t add_at(Shape shape, const std::optional<ObjectSpace<T>>& space) {
    static_assert(objects::holds<Shape>(static_cast<const Groups*>(nullptr)),
                  "an object is a shape of this library, of the list's own arithmetic: Sphere<float>, say");
    std::apply([&](auto&... groups) { (add_if_of(groups, shape, space), ...); }, groups_);
    return size_++;
  }
  template <class Group, class Shape>
  void add_if_of(Group& group, const Shape& shape, const std::optional<ObjectSpace<T>>& space) {
    if constexpr (std::is_same_v<typename Group::Shape, Shape>) group.add({shape, space, size_});
  }

  /// Those that the ray may meet first, for objects/search.hpp.
  [[nodiscard]] auto near(const Ray<T>& ray) const {
    return [this, &ray](const auto& meet) {
      T t_max = infinity<T>;
      std::apply([&](const auto&... groups) { (groups.template visit<Choice>(ray, t_max, meet), ...); },
                 groups_);
    };
  }

  Groups groups_{};
  std::size_t size_ = 0;
};

}  // namespace rayproof
