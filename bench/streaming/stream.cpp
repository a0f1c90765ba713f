/// \file
/// Compiled once for each instruction set, with RAYPROOF_INSTRUCTION_SET naming the one it is for.

#include <rayproof/arithmetics/pack.hpp>

#include "bench/streaming/streaming.hpp"

namespace rayproof {

namespace {

template <class T, std::size_t In, std::size_t Out>
void sum_columns(const Columns<T, In, Out>& columns) {
  using N = Pack<T>;
  for (std::size_t i = 0; i + N::size <= columns.size; i += N::size) {
    N sum = N::load(columns.in[0] + i);
    for (std::size_t c = 1; c < In; ++c) sum = sum + N::load(columns.in[c] + i);
    for (std::size_t c = 0; c < Out; ++c) sum.store(columns.out[c] + i);
  }
}

}  // namespace

using Built = Streaming<InstructionSet::RAYPROOF_INSTRUCTION_SET>;

template <>
void Built::run(const Columns<float, 6, 1>& columns) {
  sum_columns(columns);
}
template <>
void Built::run(const Columns<double, 6, 1>& columns) {
  sum_columns(columns);
}
template <>
void Built::run(const Columns<float, 3, 3>& columns) {
  sum_columns(columns);
}
template <>
void Built::run(const Columns<double, 3, 3>& columns) {
  sum_columns(columns);
}

}  // namespace rayproof
