#pragma once
/// \file
/// The floor under every batch kernel: reading all numbers of the problems and writing all numbers of the
/// answers.

#include <cstddef>
#include <rayproof/batch/instruction_set.hpp>

namespace rayproof {

/// What one problem reads and one answer writes, as bare columns of one length.
template <class T, std::size_t In, std::size_t Out>
struct Columns {
  const T* in[In];
  T* out[Out];
  std::size_t size;
};

/// Writes to each output column the sum of all input columns, in the widest packs of one instruction set. The
/// columns' last lanes, fewer than a pack, are left alone.
void stream(const Columns<float, 6, 1>& rays, InstructionSet set);
void stream(const Columns<double, 6, 1>& rays, InstructionSet set);
void stream(const Columns<float, 3, 3>& equations, InstructionSet set);
void stream(const Columns<double, 3, 3>& equations, InstructionSet set);

/// The same, compiled for one instruction set (stream.cpp).
template <InstructionSet set>
struct Streaming {
  static void run(const Columns<float, 6, 1>& columns);
  static void run(const Columns<double, 6, 1>& columns);
  static void run(const Columns<float, 3, 3>& columns);
  static void run(const Columns<double, 3, 3>& columns);
};

}  // namespace rayproof
