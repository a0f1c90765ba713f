#pragma once
/// \file
/// What a function returned, or wrote to its parameters, as a reply.

#include <cstddef>

#include "answering/reply.hpp"
#include "answering/says.hpp"

namespace rayproof::answering {

[[nodiscard]] inline glm::dvec3 to_dvec3(const auto& v) {
  if constexpr (requires { v.x; })
    return {v.x, v.y, v.z};
  else
    return {v[0], v[1], v[2]};
}

/// Writes what `result` says into the reply.
struct ResultTaker {
  FunctionReply& reply;
  std::size_t numbers = 0, vectors = 0;  ///< outputs met so far

  template <class R>
  void take(const R& result) {
    if constexpr (std::is_same_v<R, Position>)
      reply.position = result;
    else if constexpr (std::is_same_v<R, bool>)
      reply.is_hit = result;
    else if constexpr (std::integral<R>)
      reply.is_hit = result > 0;
    else if constexpr (std::floating_point<R>)
      add(result);
    else if constexpr (requires {
                         result.kind;
                         result.roots;
                       })
      take_roots(result);
    else if constexpr (Maybe<R>) {
      reply.is_hit = result.has_value();
      if (result.has_value()) take(*result);
    } else if constexpr (named_size<R>() > 0)
      take_vector(numbers_of(result));
    else if constexpr (Pair<R>) {
      add(result.first);
      add(result.second);
    } else if constexpr (Record<R>)
      take_record(result);
    else if constexpr (List<R>)
      take_list(result);
    else
      static_assert(List<R>, "answer_cases: the function returns nothing that says whether there is a hit");
  }

  /// What a parameter was given: numbers are t, or two hits, or t, u, v; vectors are the point, the normal.
  template <class O>
  void take_output(const O& output) {
    if constexpr (std::floating_point<O>) {
      add(output);
      ++numbers;
    } else if constexpr (VectorOf<O, 3>) {
      (vectors++ == 0 ? reply.point : reply.normal) = to_dvec3(output);
    } else if constexpr (VectorOf<O, 2>) {
      take_coordinates(static_cast<double>(output.x), static_cast<double>(output.y));
    } else if constexpr (!std::is_same_v<O, bool>) {
      take(output);
    }
  }

  /// Three numbers among the outputs are t, u and v; two beside a result that is t are u and v.
  void end_outputs(bool is_t_returned) {
    if (numbers != (is_t_returned ? 2 : 3) || reply.hits.size() < 3) return;
    take_coordinates(reply.hits[1], reply.hits[2]);
    reply.hits.erase(reply.hits.begin() + 1, reply.hits.end());
  }

 private:
  void add(auto t) { reply.hits.push_back(static_cast<double>(t)); }
  void take_coordinates(double u, double v) { reply.barycentric = glm::dvec3(1 - u - v, u, v); }

  /// GLSL's habit: (near, far); (t, u, v); (t, normal).
  template <std::size_t N>
  void take_vector(const std::array<double, N>& v) {
    add(v[0]);
    if constexpr (N == 2) add(v[1]);
    if constexpr (N == 3) take_coordinates(v[1], v[2]);
    if constexpr (N == 4) reply.normal = glm::dvec3(v[1], v[2], v[3]);
  }

  void take_record(const auto& record) {
    if constexpr (requires { record.hit; }) reply.is_hit = static_cast<bool>(record.hit);
    if constexpr (requires { record.t; }) add(record.t);
    if constexpr (requires { record.point; })
      reply.point = to_dvec3(record.point);
    else if constexpr (requires { record.position; })
      reply.point = to_dvec3(record.position);
    if constexpr (requires { record.normal; }) reply.normal = to_dvec3(record.normal);
  }

  void take_list(const auto& list) {
    for (const auto& one : list) {
      if constexpr (RecordOfT<std::remove_cvref_t<decltype(one)>>) {
        if (reply.hits.empty())
          take_record(one);
        else
          add(one.t);
      } else {
        add(one);
      }
    }
    reply.is_hit = !reply.hits.empty();
  }

  void take_roots(const auto& answer) {
    reply.kind = answer.kind;
    for (std::size_t i = 0; i < answer.count; ++i) add(answer.roots[i]);
    reply.is_hit = !reply.hits.empty();
  }
};

}  // namespace rayproof::answering
