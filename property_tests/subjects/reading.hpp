#pragma once
/// \file
/// A case as a problem of the library, in any arithmetic, and what a kernel returns as an answer to it.

#include <rayproof/normals.hpp>
#include <rayproof/plane/forms.hpp>
#include <rayproof/topics.hpp>
#include <rayproof/transform.hpp>

#include "subjects/among_neighbours.hpp"
#include "subjects/subject.hpp"

namespace rayproof {

/// The library's shape of a case's: the same, but for what the format has in several forms.
template <class S>
[[nodiscard]] const S& library_shape(const S& shape) {
  return shape;
}

/// What the case gives, exactly, in arithmetic A.
template <class A>
[[nodiscard]] auto exactly(const auto& given) {
  return convert<A>(convert<Plain<A>>(given));
}

/// Reads the cases of a topic: here those of a shape's, which a topic that is no shape specialises.
template <class Topic>
struct Reading {
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
    const auto column = [&](int i) { return exactly<A>(glm::dvec3((*question.transform)[i])); };
    return object_space<A>(column(0), column(1), column(2), column(3));
  }

  /// The case's numbers exactly, the ray taken to object space in arithmetic A.
  template <class A>
  [[nodiscard]] static Problem<A> problem(const Case& one) {
    const auto& question = std::get<RayQuestion>(one.question);
    return problem_in<A>(space<A>(question), question);
  }
  /// The same, where the object's space is known.
  template <class A>
  [[nodiscard]] static Problem<A> problem_in(const Space<A>& object, const RayQuestion& question) {
    const Ray<A> ray = exactly<A>(question.ray);
    return {object ? to_object(*object, ray) : ray, exactly<A>(shape(question))};
  }

  /// The roots of a method that takes the transform itself; only of one, in plain numbers.
  template <class Method, class T>
  [[nodiscard]] static auto roots_in_world(const Case& one) requires(
      takes_transforms<Method, T, ShapeIn<T>>) {
    const auto& question = std::get<RayQuestion>(one.question);
    const Ray<T> ray = convert<T>(question.ray);
    const ShapeIn<T> own_shape = convert<T>(shape(question));
    const Space<T> object = space<T>(question);
    return object ? rayproof::roots_in_world<Method>(*object, ray, own_shape) : Method::roots(ray, own_shape);
  }

  /// The roots by the batch kernels, the case placed among other problems; only of a batched topic.
  template <class Method, class T>
  [[nodiscard]] static auto batch_roots(const Case& one) {
    const auto& question = std::get<RayQuestion>(one.question);
    return batch::roots_among_neighbours<Method>(convert<T>(question.ray), convert<T>(shape(question)),
                                                 space<T>(question));
  }

  /// What a kernel returned as an answer to the case (T is float or double): the hits in the ray's interval;
  /// point and normal in the world, for the first of them.
  template <class Method, class T, class Result>
  [[nodiscard]] static RayAnswer answer(const Case& one, const Result& roots) {
    const auto& question = std::get<RayQuestion>(one.question);
    const Ray<T> ray = convert<T>(question.ray);
    RayAnswer result;
    const bool is_single = roots.discriminant == 0;
    if (in_interval(ray, roots.lo)) result.hits.push_back(static_cast<double>(roots.lo));
    if (!is_single && in_interval(ray, roots.hi)) result.hits.push_back(static_cast<double>(roots.hi));
    const Space<T> object = space<T>(question);
    const Problem<T> asked = problem_in<T>(object, question);
    if (result.hits.count == 0) {
      result.contact = contact_of_miss<Method, T>(asked);
      return result;
    }
    constexpr bool is_flat = std::is_base_of_v<FlatHit<T>, Result>;
    result.contact = is_single && !is_flat ? Contact::tangent : Contact::crossing;
    const auto t = static_cast<T>(result.hits.t[0]);
    result.point = glm::dvec3(point_at(ray, t));
    const auto in_world = glm::dvec3(normal_in_world(object, asked.shape, ray, t));
    if (dot(in_world, in_world) > 0) result.normal = in_world;  // not where the figure has none: NaN
    if constexpr (is_flat && std::is_same_v<ShapeIn<T>, Triangle<T>>)
      result.barycentric = glm::dvec3(T(1) - roots.u - roots.v, roots.u, roots.v);
    if constexpr (requires { Method::has_parameters; })
      if (asked.shape.form == PlaneForm::parametric || roots.u != 0 || roots.v != 0)
        result.parameters = glm::dvec2(roots.u, roots.v);
    return result;
  }

  /// Puts beside the roots what `nearest(ray, shape)` says, where the ray is in the shape's own space and a
  /// method finds the nearest hit apart from them. Both are the exact one. Where they differ one of them is
  /// wrong, and the answer has a hit too many, so that it is wrong whichever that is.
  template <class T, class Nearest>
  static void put_nearest_hit(const Case& one, RayAnswer& answer, const Nearest& nearest) {
    const auto& question = std::get<RayQuestion>(one.question);
    if (question.transform) return;
    const auto t = static_cast<double>(nearest(convert<T>(question.ray), convert<T>(shape(question))));
    HitList& hits = answer.hits;
    const double of_roots = hits.count > 0 ? hits.t[0] : infinity<double>;
    if (t == of_roots) return;
    hits.push_back(t < infinity<double> ? t : of_roots);
    if (hits.count == 1) hits.push_back(t);
    std::ranges::sort(hits.t.begin(), hits.t.begin() + static_cast<std::ptrdiff_t>(hits.count));
  }

  /// Where a method's correction has the exact t of the nearest hit of a case in float, and a bound on its
  /// error with the rounding of this sum; nothing where it is in doubt, or of a miss. Doubles do not hold
  /// that of a case in double.
  template <class Method>
  static std::vector<std::pair<double, double>> corrected_hits(const Case& one) {
    const auto& question = std::get<RayQuestion>(one.question);
    if (question.transform || one.precision != Precision::float32) return {};
    const auto [answer, is_sure, t, step, doubt] = corrected_nearest<typename Method::Correction>(
        convert<float>(question.ray), convert<float>(shape(question)));
    if (!is_sure || !(answer < infinity<float>)) return {};
    return {{double{t} - double{step}, double{doubt} + 0x1p-53 * std::abs(double{t})}};
  }

  /// Whether a method's correction leaves the nearest hit in doubt; no ray that the map moves is corrected.
  template <class Method>
  static bool is_in_doubt(const Case& one) {
    const auto& question = std::get<RayQuestion>(one.question);
    if (question.transform) return false;
    return in_precision(one.precision, [&]<class T>(T) {
      return !corrected_nearest<typename Method::Correction>(convert<T>(question.ray),
                                                             convert<T>(shape(question)))
                  .is_sure;
    });
  }

  /// Why a ray misses a plane: it is parallel to it, or runs inside it. Of other shapes no more is said.
  template <class Method, class T>
  static Contact contact_of_miss([[maybe_unused]] const Problem<T>& asked) {
    if constexpr (std::is_same_v<ShapeIn<T>, Plane<T>>) {
      const auto [normal, d] = plane::as_implicit(asked.shape);
      if (dot(normal, asked.ray.direction) != 0) return Contact::none;
      const bool is_inside = dot(normal, asked.ray.origin) + d == 0;
      constexpr bool distinguishes = !requires { Method::calls_in_plane_parallel; };
      return is_inside && distinguishes ? Contact::in_surface : Contact::parallel;
    }
    return Contact::none;
  }
};

template <>
struct Reading<quadratic::Topic> {
  template <class A>
  [[nodiscard]] static quadratic::Topic::Problem<A> problem(const Case& one) {
    return exactly<A>(std::get<Quadratic<double>>(one.question));
  }

  template <class Method, class T>
  [[nodiscard]] static Roots<T> batch_roots(const Case& one) {
    return batch::roots_among_neighbours<Method>(problem<T>(one));
  }

  template <class Method, class T>
  [[nodiscard]] static QuadraticAnswer<double> answer(const Case& one, const Roots<T>& roots) {
    const QuadraticAnswer<T> narrow = read(problem<T>(one), roots);
    return {narrow.kind,
            narrow.count,
            {static_cast<double>(narrow.roots[0]), static_cast<double>(narrow.roots[1])}};
  }
};

template <>
struct Reading<point_in_polygon::Topic> {
  template <class A>
  [[nodiscard]] static point_in_polygon::Topic::Problem<A> problem(const Case& one) {
    return convert<A>(std::get<PointAndPolygon<double>>(one.question));
  }

  template <class Method, class T>
  [[nodiscard]] static Position answer(const Case& /*one*/, Position position) {
    return position;
  }
};

}  // namespace rayproof
