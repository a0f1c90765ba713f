#pragma once
/// \file
/// The arguments of a call, made of a problem.

#include <array>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "answering/letters.hpp"
#include "answering/problem.hpp"

namespace rayproof::answering {

/// What holds a parameter's value during the call.
template <class P>
struct Held {
  using A = std::decay_t<P>;
  using Type = A;
};
template <class T>
struct Held<const T*> {
  using Type = std::array<T, 3>;
};
template <class E>
struct Held<std::span<const E>> {
  using Type = std::vector<E>;
};
template <class P>
using HeldFor = typename Held<std::conditional_t<is_output<P>, P, std::decay_t<P>>>::Type;

/// The held value as the parameter wants it.
template <class P>
[[nodiscard]] decltype(auto) pass(HeldFor<P>& held) {
  if constexpr (is_pointer_to_three<std::decay_t<P>>) {
    return std::as_const(held).data();
  } else if constexpr (is_output<P>) {
    return (held);
  } else {
    return std::move(held);
  }
}

/// Makes arguments of a problem, one after the other: each takes its numbers from the front of the row.
struct ArgumentMaker {
  const Problem& problem;
  const double* next;

  template <class P>
  [[nodiscard]] HeldFor<P> make() {
    using H = HeldFor<P>;
    if constexpr (is_output<P>) {
      return H{};
    } else if constexpr (is_ray<H>) {
      return convert<typename StructureNumber<H>::Type>(problem.ray);
    } else if constexpr (is_matrix<H>) {
      return H(problem.asked->transform.value_or(glm::dmat4(1)));
    } else if constexpr (std::is_same_v<H, bool>) {
      return *next++ != 0;
    } else if constexpr (std::floating_point<H>) {
      return static_cast<H>(*next++);
    } else if constexpr (VectorOf<H, 3>) {
      return make_vector<H, 3>(std::exchange(next, next + 3));
    } else if constexpr (VectorOf<H, 2>) {
      return make_vector<H, 2>(std::exchange(next, next + 2));
    } else if constexpr (is_triple_of_vectors<H>) {
      using V = typename H::value_type;
      const double* const from = std::exchange(next, next + 9);
      return H{make_vector<V, 3>(from), make_vector<V, 3>(from + 3), make_vector<V, 3>(from + 6)};
    } else if constexpr (!std::is_void_v<typename ElementOf<H>::Type>) {
      return make_list<H>();
    } else {
      return make_from_structure<H>();
    }
  }

 private:
  template <class H>
  [[nodiscard]] H make_list() const {
    using E = typename ElementOf<H>::Type;
    H list;
    if constexpr (VectorOf<E, 3>) {
      for (const glm::dvec3& v : *problem.fields.points) list.push_back(make_vector<E, 3>(&v.x));
    } else {
      for (const Vec2<double>& v : *problem.fields.points_of_plane) list.push_back(make_vector<E, 2>(&v.x));
    }
    return list;
  }

  template <class H>
  [[nodiscard]] H make_from_structure() const {
    H made{};
    const auto from = [&]<class C>(const C& given) {
      if constexpr (is_made_of<H, C>()) made = make_structure<H>(given);
    };
    if (problem.asked != nullptr) {
      std::visit(from, problem.asked->shape);
    } else {
      std::visit(from, *problem.question);
    }
    return made;
  }
};

}  // namespace rayproof::answering
