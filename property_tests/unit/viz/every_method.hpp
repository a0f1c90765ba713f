#pragma once
/// \file
/// Problems for every method of every topic, from tame to the ends of the exponent range.

#include <cmath>
#include <cstdint>
#include <random>
#include <rayproof/topics.hpp>

#include "viz/record.hpp"

namespace rayproof::viz {

/// Numbers of either sign whose exponents are uniform within ±reach, some of them whole, some of them 0.
class CaseSource {
 public:
  explicit CaseSource(std::uint64_t seed) : bits_(seed) {}

  double number(int reach) {
    const auto kind = bits_() % 16;
    if (kind == 0) return 0;
    const double sign = bits_() % 2 == 0 ? 1 : -1;
    if (kind < 4) return sign * static_cast<double>(bits_() % 8);
    const double significand = 1 + static_cast<double>(bits_() >> 11) * 0x1p-53;
    const int exponent = static_cast<int>(bits_() % static_cast<unsigned>(2 * reach + 1)) - reach;
    return sign * std::ldexp(significand, exponent);
  }
  /// A number one last bit or so away from another.
  double beside(double x) { return x * (1 + static_cast<double>(bits_() % 5) * 0x1p-23 - 0x1p-22); }

  template <class T>
  T rounded(int reach) {
    return static_cast<T>(number(reach));
  }

 private:
  std::mt19937_64 bits_;
};

template <class T>
[[nodiscard]] quadratic::Topic::Problem<T> random_problem(quadratic::Topic /*topic*/, CaseSource& source,
                                                          int reach) {
  const T b = source.rounded<T>(reach);
  const T a = source.rounded<T>(reach);
  const bool is_near_double = source.number(1) > 0 && a != 0;
  const T c = is_near_double ? static_cast<T>(source.beside(static_cast<double>(b * b / (4 * a))))
                             : source.rounded<T>(reach);
  return {{a, b, c}};
}

/// Rays of every topic of shapes; `figure` makes the shape from numbers and vectors of the same reach.
template <class Topic, class T, class MakeShape>
[[nodiscard]] typename Topic::template Problem<T> random_ray_problem(CaseSource& source, int reach,
                                                                     MakeShape&& make_shape) {
  const auto number = [&] { return source.rounded<T>(reach); };
  const auto vector = [&] { return vec3<T>{number(), number(), number()}; };
  const Ray<T> ray{vector(), vector()};
  return {ray, make_shape(number, vector)};
}

template <class T>
[[nodiscard]] sphere::Topic::Problem<T> random_problem(sphere::Topic /*topic*/, CaseSource& source,
                                                       int reach) {
  return random_ray_problem<sphere::Topic, T>(source, reach, [](auto number, auto vector) {
    return Sphere<T>{vector(), std::abs(number())};
  });
}

template <class T>
[[nodiscard]] plane::Topic::Problem<T> random_problem(plane::Topic /*topic*/, CaseSource& source, int reach) {
  constexpr PlaneForm forms[] = {PlaneForm::implicit, PlaneForm::point_normal, PlaneForm::parametric};
  const auto form = forms[static_cast<std::size_t>(std::abs(source.number(1)) * 16) % 3];
  return random_ray_problem<plane::Topic, T>(source, reach, [&](auto number, auto vector) {
    return Plane<T>{form, vector(), vector(), number(), vector(), vector()};
  });
}

template <class T>
[[nodiscard]] triangle::Topic::Problem<T> random_problem(triangle::Topic /*topic*/, CaseSource& source,
                                                         int reach) {
  return random_ray_problem<triangle::Topic, T>(source, reach, [](auto /*number*/, auto vector) {
    return Triangle<T>{vector(), vector(), vector()};
  });
}

template <class T>
[[nodiscard]] box::Topic::Problem<T> random_problem(box::Topic /*topic*/, CaseSource& source, int reach) {
  return random_ray_problem<box::Topic, T>(source, reach, [](auto /*number*/, auto vector) {
    const vec3<T> a = vector();
    const vec3<T> b = vector();
    return rayproof::Box<T>{{min(a.x, b.x), min(a.y, b.y), min(a.z, b.z)},
                            {max(a.x, b.x), max(a.y, b.y), max(a.z, b.z)}};
  });
}

template <class T>
[[nodiscard]] parallelepiped::Topic::Problem<T> random_problem(parallelepiped::Topic /*topic*/,
                                                               CaseSource& source, int reach) {
  return random_ray_problem<parallelepiped::Topic, T>(source, reach, [](auto /*number*/, auto vector) {
    return Parallelepiped<T>{vector(), {vector(), vector(), vector()}};
  });
}

template <class T>
[[nodiscard]] cylinder::Topic::Problem<T> random_problem(cylinder::Topic /*topic*/, CaseSource& source,
                                                         int reach) {
  const bool is_capped = source.number(1) > 0;
  return random_ray_problem<cylinder::Topic, T>(source, reach, [&](auto number, auto /*vector*/) {
    const auto radius = [&] {
      const T r = std::abs(number());
      return r == T(0) ? T(1) : r;
    };
    return Cylinder<T>{radius(), radius(), std::abs(number()), is_capped};
  });
}

/// Calls `check.operator()<Topic, Method>(problem)` with many problems.
template <class T, class Topic, class Method, class Check>
void put_problems(Check&& check) {
  CaseSource source(20);
  for (const int reach : {0, 4, 20, std::numeric_limits<T>::max_exponent - 1}) {
    for (int i = 0; i < 400; ++i) {
      check.template operator()<Topic, Method>(random_problem<T>(Topic{}, source, reach));
    }
  }
}

/// The same for every method that takes any arithmetic.
template <class T, class Check>
void for_every_recordable_method(Check&& check) {
  Topics::for_each([&]<class Topic>(std::type_identity<Topic>) {
    Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
      if constexpr (Recordable<Method, Recorded<T, Shadow>>) {
        put_problems<T, Topic, Method>(check);
      }
    });
  });
}

}  // namespace rayproof::viz
