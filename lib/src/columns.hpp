#pragma once
/// \file
/// How a kernel goes over columns of numbers, a pack at a time. Included by what is compiled once for each
/// instruction set: all stands in an anonymous namespace, so that the linker can put no other one's code in
/// its place.

#include <rayproof/arithmetics/pack.hpp>
#include <rayproof/ray.hpp>

#include <algorithm>
#include <array>
#include <tuple>

/// Puts all that a function calls into the function itself; not under AddressSanitizer, which would take
/// minutes.
#ifdef __SANITIZE_ADDRESS__
#define RAYPROOF_FLAT
#else
#define RAYPROOF_FLAT [[gnu::flatten]]
#endif

namespace rayproof::batch {

namespace {

/// How a pack is read from a column and written to one; a plain number is a pack of one lane. A pack of
/// doubles reads and writes columns of floats, too, for the quick phases.
template <class N>
struct LaneAccess {
  static constexpr std::size_t width = N::size;
  template <class T>
  static N load(const T* from) {
    if constexpr (std::same_as<T, Plain<N>>) {
      return N::load(from);
    } else {
      return load_floats<N>(from);
    }
  }
  template <class T>
  static void store(const N& value, T* to) {
    if constexpr (std::same_as<T, Plain<N>>) {
      value.store(to);
    } else {
      store_floats(value, to);
    }
  }
};
template <std::floating_point T>
struct LaneAccess<T> {
  static constexpr std::size_t width = 1;
  static T load(const T* from) { return *from; }
  static void store(T value, T* to) { *to = value; }
};

/// Calls `solve(in, out)` for every `width` lanes of the columns. The last lanes are padded with copies of
/// the very last one, so that they take the same path as all others: the same loop, since all that `solve`
/// calls becomes part of it, which a second one would have g++ do twice. Where 1 column is `wanted`, the
/// others are not written. What is written are `To`, as many lanes. The last columns that are read may be
/// null: `common` has a number for each of these, which stands in all lanes.
template <class N, class To = N, class T, std::size_t In, std::size_t Out, class Solve,
          std::size_t Common = 0>
void run(const T* const (&in)[In], T* const (&out)[Out], std::size_t size, const Solve& solve,
         std::size_t wanted = Out, const std::array<T, Common>& common = {}) {
  using Access = LaneAccess<N>;
  constexpr std::size_t lanes = Access::width;
  const std::size_t whole = size - size % lanes;
  constexpr std::size_t always = In - Common;
  T rest_in[In][lanes];
  T rest_out[Out][lanes];
  const T* source[In];
  T* target[Out];
  // A common number is read again and again from one pack of it: all bits of `i` that count are masked out.
  std::array<std::array<T, lanes>, Common> same;
  std::array<std::size_t, Common> moving;
  for (std::size_t column = 0; column < In; ++column) source[column] = in[column];
  for (std::size_t c = 0; c < Common; ++c) {
    for (T& lane : same[c]) lane = common[c];
    const bool is_common = in[always + c] == nullptr;
    moving[c] = is_common ? 0 : ~std::size_t{0};
    if (is_common) source[always + c] = same[c].data();
  }
  for (std::size_t column = 0; column < Out; ++column) target[column] = out[column];
  for (std::size_t end = whole;;) {
    N from[In];
    To to[Out];
    for (std::size_t i = 0; i < end; i += lanes) {
      for (std::size_t column = 0; column < always; ++column) from[column] = Access::load(source[column] + i);
      for (std::size_t c = 0; c < Common; ++c)
        from[always + c] = Access::load(source[always + c] + (i & moving[c]));
      solve(from, to);
      LaneAccess<To>::store(to[0], target[0] + i);
      if (wanted == 1) continue;
      for (std::size_t column = 1; column < Out; ++column)
        LaneAccess<To>::store(to[column], target[column] + i);
    }
    if (whole == size || source[0] == rest_in[0]) break;

    for (std::size_t column = 0; column < In; ++column) {
      if (column >= always && moving[column - always] == 0) continue;
      for (std::size_t lane = 0; lane < lanes; ++lane)
        rest_in[column][lane] = in[column][std::min(whole + lane, size - 1)];
      source[column] = rest_in[column];
    }
    for (std::size_t column = 0; column < Out; ++column) target[column] = rest_out[column];
    end = lanes;
  }
  for (std::size_t column = 0; column < wanted; ++column) {
    for (std::size_t i = whole; i < size; ++i) out[column][i] = rest_out[column][i - whole];
  }
}

/// One ray a lane.
template <class N>
Ray<N> ray_of(const N (&column)[8]) {
  return {{column[0], column[1], column[2]}, {column[3], column[4], column[5]}, column[6], column[7]};
}

/// A table of kernels, each of which `enter(kernel)` has given its function.
template <class Table, class Enter>
constexpr Table filled(const Enter& enter) {
  Table table;
  std::apply([&](auto&... kernels) { (enter(kernels), ...); }, table);
  return table;
}

}  // namespace

}  // namespace rayproof::batch
