#include "bench/streaming/streaming.hpp"

namespace rayproof {

namespace {

template <InstructionSet... sets>
struct Sets {};

template <class T, std::size_t In, std::size_t Out, InstructionSet... sets>
void run(const Columns<T, In, Out>& columns, InstructionSet set, Sets<sets...> /*built*/) {
  ((set == sets ? Streaming<sets>::run(columns) : void()), ...);
}

template <class T, std::size_t In, std::size_t Out>
void dispatch(const Columns<T, In, Out>& columns, InstructionSet set) {
  run(columns, set, Sets<RAYPROOF_BUILT_FOR>());
}

}  // namespace

void stream(const Columns<float, 6, 1>& rays, InstructionSet set) { dispatch(rays, set); }
void stream(const Columns<double, 6, 1>& rays, InstructionSet set) { dispatch(rays, set); }
void stream(const Columns<float, 3, 3>& equations, InstructionSet set) { dispatch(equations, set); }
void stream(const Columns<double, 3, 3>& equations, InstructionSet set) { dispatch(equations, set); }

}  // namespace rayproof
