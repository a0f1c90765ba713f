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
/// One object is tested after the other, in the order of their shapes: a program with thousands of them asks
/// its own tree first, and this list of the few objects in a leaf.

#include <algorithm>
#include <optional>
#include <rayproof/normals.hpp>
#include <rayproof/topics.hpp>
#include <rayproof/transform.hpp>
#include <tuple>
#include <utility>
#include <vector>

namespace rayproof {

/// One hit of a ray with an object.
template <std::floating_point T>
struct HitRecord {
  T t;                ///< in lengths of the ray's direction
  std::size_t index;  ///< of the object, in the order in which they were added
  vec3<T> point;      ///< p(t)
  /// A unit vector: outward from a solid, else as normals.hpp has it; also where it points away from the
  /// ray's origin.
  vec3<T> normal;
  T u;  ///< with `v` the place in a plane or triangle, as FlatHit has them; 0 of other shapes
  T v;
};

/// The method of a shape's topic that an ObjectList asks.
struct PlainMethods {
  template <class Topic>
  using method = typename Topic::Plain;
};
/// No verdict is wrong, and each t is the exact one rounded once; but of polygons and cylinders under a
/// matrix, whose ray is rounded on its way into the object's space.
struct ExactMethods {
  template <class Topic>
  using method = typename Topic::Exact;
};

namespace objects {

/// A shape where its matrix puts it.
template <class Topic, class S, std::floating_point T>
struct ListedObject {
  using Shape = S;
  S shape;
  std::optional<ObjectSpace<T>> space;
  std::size_t index;

  template <class Choice>
  [[nodiscard]] auto roots(const Ray<T>& ray) const {
    using Method = typename Choice::template method<Topic>;
    return space ? roots_in_world<Method>(*space, ray, shape) : Method::roots(ray, shape);
  }

  template <class Roots>
  [[nodiscard]] HitRecord<T> record(const Ray<T>& ray, const T& t, const Roots& roots) const {
    HitRecord<T> hit{t, index, point_at(ray, t), normal_in_world(space, shape, ray, t), T(0), T(0)};
    if constexpr (requires { roots.u; }) std::tie(hit.u, hit.v) = std::tie(roots.u, roots.v);
    return hit;
  }
};

template <class Topic, class T, template <class> class Shape>
auto vectors_of(const RayTopic<Shape>* /*topic*/)
    -> std::tuple<std::vector<ListedObject<Topic, Shape<T>, T>>>;
template <class Topic, class T>
auto vectors_of(const void* /*no shape*/) -> std::tuple<>;

/// Whether a list of these vectors has one for the shape.
template <class Shape, class... Vectors>
constexpr bool holds(const std::tuple<Vectors...>* /*vectors*/) {
  return (std::is_same_v<typename Vectors::value_type::Shape, Shape> || ...);
}

template <class T, class... Topics>
auto vectors_of_all(TypeList<Topics...>)
    -> decltype(std::tuple_cat(vectors_of<Topics, T>(static_cast<const Topics*>(nullptr))...));

}  // namespace objects

/// See the head of the file.
template <std::floating_point T, class Choice = PlainMethods>
class ObjectList {
 public:
  /// Adds an object; its index is returned.
  template <class Shape>
  std::size_t add(Shape shape) {
    return add_at(std::move(shape), std::nullopt);
  }
  /// The same under an affine object-to-world matrix (last row 0 0 0 1). What a singular one makes is missed.
  template <class Shape>
  std::size_t add(Shape shape, const glm::mat<4, 4, T>& object_to_world) {
    return add_at(std::move(shape), object_space<T>(object_to_world));
  }
  [[nodiscard]] std::size_t size() const { return size_; }

  /// The nearest hit in the ray's interval; of several at one t, that of the object added first.
  [[nodiscard]] std::optional<HitRecord<T>> nearest(const Ray<T>& ray) const {
    std::optional<HitRecord<T>> best;
    visit(ray, [&](const auto& object, const auto& roots) {
      if (!rayproof::any(ray, roots)) return false;
      const T t = rayproof::nearest(ray, roots);
      if (!best || std::pair(t, object.index) < std::pair(best->t, best->index))
        best = object.record(ray, t, roots);
      return false;
    });
    return best;
  }

  /// Whether anything is hit in the ray's interval: what a shadow ray asks.
  [[nodiscard]] bool any(const Ray<T>& ray) const {
    return visit(ray, [&](const auto&, const auto& roots) { return rayproof::any(ray, roots); });
  }

  /// Every hit in the ray's interval, ascending; of a solid both, of a tangent one.
  [[nodiscard]] std::vector<HitRecord<T>> all(const Ray<T>& ray) const {
    std::vector<HitRecord<T>> hits;
    visit(ray, [&](const auto& object, const auto& roots) {
      if (in_interval(ray, roots.lo)) hits.push_back(object.record(ray, roots.lo, roots));
      const bool is_one = roots.discriminant == T(0);
      if (!is_one && in_interval(ray, roots.hi)) hits.push_back(object.record(ray, roots.hi, roots));
      return false;
    });
    std::ranges::sort(hits, std::less{}, [](const HitRecord<T>& hit) { return std::pair(hit.t, hit.index); });
    return hits;
  }

 private:
  using Objects = decltype(objects::vectors_of_all<T>(Topics{}));

  template <class Shape>
  std::size_t add_at(Shape shape, const std::optional<ObjectSpace<T>>& space) {
    static_assert(objects::holds<Shape>(static_cast<const Objects*>(nullptr)),
                  "an object is a shape of this library, of the list's own arithmetic: Sphere<float>, say");
    std::apply([&](auto&... vectors) { (add_if_of(vectors, shape, space), ...); }, objects_);
    return size_++;
  }
  template <class Object, class Shape>
  void add_if_of(std::vector<Object>& objects, const Shape& shape,
                 const std::optional<ObjectSpace<T>>& space) {
    if constexpr (std::is_same_v<typename Object::Shape, Shape>) objects.push_back({shape, space, size_});
  }

  /// Calls `meet(object, roots)` for each object until that gives true; whether it did.
  template <class Meet>
  bool visit(const Ray<T>& ray, const Meet& meet) const {
    const auto visit_each = [&](const auto& objects) {
      return std::ranges::any_of(
          objects, [&](const auto& object) { return meet(object, object.template roots<Choice>(ray)); });
    };
    return std::apply([&](const auto&... vectors) { return (visit_each(vectors) || ...); }, objects_);
  }

  Objects objects_{};
  std::size_t size_ = 0;
};

}  // namespace rayproof
