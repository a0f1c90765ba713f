#pragma once
/// \file
/// Ray cases as problems of the library, and hits as answers: what the readings of all shapes share.

#include <rayproof/batch/among_neighbours.hpp>
#include <rayproof/normals.hpp>
#include <rayproof/transform.hpp>

#include "subjects/solve.hpp"

namespace rayproof {

/// The library's shape of a case's: the same, but for what the format has in several forms.
template <class S>
[[nodiscard]] const S& library_shape(const S& shape) {
  return shape;
}

/// A miss of which nothing more is said.
struct PlainMiss {
  template <class Method, class Problem>
  [[nodiscard]] static Contact contact(const Problem& /*asked*/) {
    return Contact::none;
  }
};

/// Reads the cases of a shape's topic. Why a ray misses is `Miss::contact<Method>(problem)`'s to say.
template <class Topic, class Miss = PlainMiss>
struct RayReading {
  template <class A>
  using Problem = typename Topic::template Problem<A>;
  template <class A>
  using ShapeIn = decltype(Problem<A>::shape);
  template <class A>
  using Space = std::optional<ObjectSpace<A>>;

  /// The case's shape as the library has it; the case is of this topic.
  [[nodiscard]] static ShapeIn<double> shape(const RayQuestion& question) {
    return std::visit(
        []<class S>(const S& given) -> ShapeIn<double> {
          if constexpr (std::is_convertible_v<decltype(library_shape(given)), ShapeIn<double>>)
            return library_shape(given);
          else
            throw std::logic_error("a case was given to the wrong topic");
        },
        question.shape);
  }

  /// The object's space in arithmetic A, computed from the exact matrix in A.
  template <class A>
  [[nodiscard]] static Space<A> space(const RayQuestion& question) {
    if (!question.transform) return std::nullopt;
    const auto column = [&](int i) {
      return convert<A>(convert<Plain<A>>(glm::dvec3((*question.transform)[i])));
    };
    return object_space<A>(column(0), column(1), column(2), column(3));
  }

  template <class A>
  [[nodiscard]] static Problem<A> problem(const Case& one) {
    const auto& question = std::get<RayQuestion>(one.question);
    const Space<A> object = space<A>(question);
    const Ray<A> ray = convert<A>(convert<Plain<A>>(question.ray));
    return {object ? to_object(*object, ray) : ray, convert<A>(convert<Plain<A>>(shape(question)))};
  }

  template <class Method, class T>
  [[nodiscard]] static Roots<T> batch_roots(const Case& one) {
    const auto& question = std::get<RayQuestion>(one.question);
    return batch::roots_among_neighbours<Method>(convert<T>(question.ray), convert<T>(shape(question)),
                                                 space<T>(question));
  }

  /// The hits in the ray's interval; point and normal in the world, for the first of them.
  template <class Method, class T, class Result>
  [[nodiscard]] static RayAnswer answer(const Case& one, const Result& roots) {
    const auto& question = std::get<RayQuestion>(one.question);
    const Ray<T> ray = convert<T>(question.ray);
    RayAnswer result;
    const bool is_single = roots.discriminant == 0;
    if (in_interval(ray, roots.lo)) result.hits.push_back(static_cast<double>(roots.lo));
    if (!is_single && in_interval(ray, roots.hi)) result.hits.push_back(static_cast<double>(roots.hi));
    const Problem<T> asked = problem<T>(one);
    if (result.hits.count == 0) {
      result.contact = Miss::template contact<Method>(asked);
      return result;
    }
    constexpr bool is_flat = std::is_base_of_v<FlatHit<T>, Result>;
    result.contact = is_single && !is_flat ? Contact::tangent : Contact::crossing;
    describe(question, asked, static_cast<T>(result.hits.t[0]), result);
    if constexpr (is_flat && std::is_same_v<ShapeIn<T>, Triangle<T>>)
      result.barycentric = glm::dvec3(T(1) - roots.u - roots.v, roots.u, roots.v);
    return result;
  }

 private:
  template <class T>
  static void describe(const RayQuestion& question, const Problem<T>& asked, T t, RayAnswer& result) {
    result.point = glm::dvec3(point_at(convert<T>(question.ray), t));
    const vec3<T> normal = normal_at(asked.shape, point_at(asked.ray, t));
    const Space<T> object = space<T>(question);
    const auto in_world = glm::dvec3(object ? normal_to_world(*object, normal) : normal);
    if (dot(in_world, in_world) > 0) result.normal = in_world;  // not where the figure has none: NaN
  }
};

/// A topic with nothing of its own is a shape's.
template <class Topic>
struct Reading : RayReading<Topic> {};

}  // namespace rayproof
