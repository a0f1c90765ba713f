#include "bench/streaming/streaming.hpp"

namespace rayproof {

namespace {

template <class T, std::size_t In, std::size_t Out>
void dispatch(const Columns<T, In, Out>& columns, [[maybe_unused]] InstructionSet set) {
#ifdef RAYPROOF_X86
  if (set == InstructionSet::avx2) return Streaming<InstructionSet::avx2>::run(columns);
  if (set == InstructionSet::avx512) return Streaming<InstructionSet::avx512>::run(columns);
#endif
  Streaming<InstructionSet::baseline>::run(columns);
}

}  // namespace

void stream(const Columns<float, 6, 1>& rays, InstructionSet set) { dispatch(rays, set); }
void stream(const Columns<double, 6, 1>& rays, InstructionSet set) { dispatch(rays, set); }
void stream(const Columns<float, 3, 3>& equations, InstructionSet set) { dispatch(equations, set); }
void stream(const Columns<double, 3, 3>& equations, InstructionSet set) { dispatch(equations, set); }

}  // namespace rayproof
