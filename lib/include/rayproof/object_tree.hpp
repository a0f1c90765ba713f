#pragma once
/// \file
/// A list of objects with a tree over it: the answers of the list, for thousands of objects.
///
/// \code
/// rayproof::ObjectList<float> objects;
/// for (int i = 0; i < 1000; ++i) objects.add(rayproof::Sphere<float>{{3 * i, 0, 9}, 1});
/// const rayproof::ObjectTree tree(std::move(objects));
/// const auto hit = tree.nearest({{300, 0, 0}, {0, 0, 1}});
/// assert(hit && hit->index == 100 && hit->t == 8);
/// \endcode

#include <rayproof/object_list.hpp>
#include <rayproof/objects/bounds_of.hpp>
#include <rayproof/objects/bounds_tree.hpp>
#include <utility>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// Asks only the objects whose box the ray comes near. A plane has none, and neither has an object with
/// numbers beyond 2^500: every ray asks them.
///
/// The boxes are rounded outwards, and no rounding of the search leaves out one that the exact ray meets. A
/// method's hit may lie beside the exact object: it is found, too, while it is not farther from it than 256ε
/// of the largest coordinates of the boxes and the ray's origin, ε being T's unit roundoff. So the answers
/// are those of the list, but where a matrix, or a shape, is so badly conditioned that a method errs by more
/// than that.
///
/// `Search` is who searches the boxes: objects::EmbreeTree (objects/embree_tree.hpp) is the faster one.
template <std::floating_point T, class Choice = PlainMethods, class Search = objects::BoundsTree>
class ObjectTree {
 public:
  /// Takes the objects and builds the tree, in O(n log n).
  explicit ObjectTree(ObjectList<T, Choice> objects) : objects_(std::move(objects)), tree_(boxes()) {
    if (!boxed_.empty()) reach_ = objects::reach_of(tree_.bounds());
  }
  [[nodiscard]] std::size_t size() const { return objects_.size(); }

  /// The nearest hit in the ray's interval; of several at one t, that of the object added first.
  [[nodiscard]] std::optional<HitRecord<T>> nearest(const Ray<T>& ray) const {
    return objects::nearest_of<Choice>(ray, near(ray));
  }
  /// Whether anything is hit in the ray's interval: what a shadow ray asks.
  [[nodiscard]] bool any(const Ray<T>& ray) const { return objects::any_of<Choice>(ray, near(ray)); }
  /// Every hit in the ray's interval, ascending; of a solid both, of a tangent one.
  [[nodiscard]] std::vector<HitRecord<T>> all(const Ray<T>& ray) const {
    return objects::all_of<Choice>(ray, near(ray));
  }

 private:
  /// How far around a box a method is still asked, in parts of the largest coordinates.
  static constexpr double margin = double{256 * unit_roundoff<T>};

  /// The objects' boxes, where they have one.
  [[nodiscard]] std::vector<objects::Bounds> boxes() {
    std::vector<objects::Bounds> boxes;
    std::size_t n = 0;
    objects_.for_each([&](const auto& object) {
      std::optional<ObjectSpace<double>> space;
      if (object.space) space = convert<double>(*object.space);
      if (const auto box = objects::bounds_of(object.shape, space)) {
        boxes.push_back(*box);
        boxed_.push_back(n++);
      } else {
        unbounded_.push_back(n++);
      }
      return T(0);
    });
    return boxes;
  }

  /// Those that are near a ray, for objects/search.hpp.
  [[nodiscard]] auto near(const Ray<T>& ray) const {
    return [this, &ray](const auto& meet) {
      T t_max = infinity<T>;
      for (const std::size_t n : unbounded_) {
        t_max = objects_.meet_nth(n, meet);
        if (std::isnan(t_max)) return;
      }
      const auto against = objects::with_margin(convert<double>(ray), margin, reach_);
      tree_.visit(against, t_max,
                  [&](std::uint32_t i) { return static_cast<double>(objects_.meet_nth(boxed_[i], meet)); });
    };
  }

  ObjectList<T, Choice> objects_;
  // Before the tree, whose boxes fill them.
  std::vector<std::size_t> boxed_{}, unbounded_{};  ///< in the order of `for_each`
  Search tree_;
  double reach_ = 0;
};
template <class T, class Choice>
ObjectTree(ObjectList<T, Choice>) -> ObjectTree<T, Choice>;

}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>
