#pragma once
/// \file
/// How a kernel corrects plain answers. Included by what is compiled once for each instruction set: all
/// stands in an anonymous namespace, so that the linker can put no other one's code in its place.

#include <rayproof/arithmetics/double_double.hpp>
#include <rayproof/batch/kernels.hpp>

#include "columns.hpp"

namespace rayproof::batch {

namespace {

/// A number in each lane, and the same one with more digits.
template <class N>
struct InBoth {
  N narrow;
  DoubleDouble<N> wide;
};
template <class Abi>
struct InBoth<Pack<float, Abi>> {
  Pack<float, Abi> narrow;
  WidePack<Abi> wide;
};

template <class Abi>
struct LaneAccess<InBoth<Pack<float, Abi>>> {
  using N = Pack<float, Abi>;
  static constexpr std::size_t width = N::size;
  static InBoth<N> load(const float* from) { return {N::load(from), WidePack<Abi>::load(from)}; }
};
template <class Abi>
struct LaneAccess<InBoth<Pack<double, Abi>>> {
  using N = Pack<double, Abi>;
  static constexpr std::size_t width = N::size;
  static InBoth<N> load(const double* from) {
    const N given = N::load(from);
    return {given, DoubleDouble<N>::of_any_size(given)};
  }
};

/// What a correction leaves in memory between its loops.
template <class T>
struct CorrectionColumns {
  static constexpr std::size_t size = quick_block;
  alignas(64) T t[size], face[size], value[size], slope[size];
};

/// The nearest hits of at most `quick_block` rays, corrected, in three loops: the processor is at several
/// packs at once where little is done to each. What is not sure is NaN. Returns whether all is.
template <class Method, class Problem, class T>
RAYPROOF_FLAT bool correct(const Lanes<Problem>& given, T* nearest) {
  const Lanes<Problem> in = given;
  using Correction = typename Method::Correction;
  using N = Pack<T>;
  using Both = InBoth<N>;
  using W = decltype(Both::wide);
  const auto& [ox, oy, oz, dx, dy, dz, t_min, t_max] = in.columns;
  CorrectionColumns<T> between;
  auto& [t, face, value, slope] = between;

  const auto start = [&](const N(&c)[8], N(&to)[2]) {
    auto at = Correction::start(ray_of<N>(c), convert<N>(in.shape));
    to[0] = at.t;
    to[1] = at.face;
  };
  run<N>(in.columns, {t, face}, in.size, start, 2, in.interval);

  const auto shape = prepared<Correction>(convert<WiderThan<T>>(in.shape));
  const auto residual = [&](const Both(&c)[8], N(&to)[2]) {
    Ray<N> ray{{c[0].narrow, c[1].narrow, c[2].narrow}, {c[3].narrow, c[4].narrow, c[5].narrow}};
    Ray<W> wide{{c[0].wide, c[1].wide, c[2].wide}, {c[3].wide, c[4].wide, c[5].wide}};
    auto f = Correction::residual(ray, wide, CorrectionStart<N>{c[6].narrow, c[7].narrow},
                                  CorrectionStart<W>{c[6].wide, c[7].wide}, convert<W>(shape));
    to[0] = f.value;
    to[1] = f.slope;
  };
  run<Both, N>({ox, oy, oz, dx, dy, dz, t, face}, {value, slope}, in.size, residual);

  Mask<N> is_sure(true);
  const auto fill = [&](const N(&c)[12], N(&to)[1]) {
    Ray<N> ray{{c[0], c[1], c[2]}, {c[3], c[4], c[5]}, c[10], c[11]};
    auto quick =
        Correction::nearest(ray, CorrectionStart<N>{c[6], c[7]}, Linear<N>{c[8], c[9]}, convert<W>(shape));
    is_sure = is_sure && quick.is_sure;
    to[0] = select(quick.is_sure, quick.answer, N(not_a_number<T>));
  };
  run<N>({ox, oy, oz, dx, dy, dz, t, face, value, slope, t_min, t_max}, {nearest}, in.size, fill, 1,
         in.interval);
  return std::experimental::all_of(is_sure);
}

/// Whether enough answers are NaN for packs to answer all anew.
template <class T>
[[nodiscard]] bool are_many_unsure(const T* answers, std::size_t size) {
  std::size_t unsure = 0;
  for (std::size_t i = 0; i < size; ++i) unsure += answers[i] != answers[i] ? 1 : 0;
  return unsure > size / 16;
}

}  // namespace

}  // namespace rayproof::batch
