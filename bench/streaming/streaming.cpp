#include "bench/streaming/streaming.hpp"

namespace rayproof {

namespace {

template <InstructionSet... built, class T, std::size_t In, std::size_t Out>
void dispatch(const Columns<T, In, Out>& columns, InstructionSet set) {
  ((set == built ? Streaming<built>::run(columns) : void()), ...);
}

}  // namespace

void stream(const Columns<float, 6, 1>& rays, InstructionSet set) { dispatch<RAYPROOF_BUILT_FOR>(rays, set); }
void stream(const Columns<double, 6, 1>& rays, InstructionSet set) {
  dispatch<RAYPROOF_BUILT_FOR>(rays, set);
}
void stream(const Columns<float, 3, 3>& equations, InstructionSet set) {
  dispatch<RAYPROOF_BUILT_FOR>(equations, set);
}
void stream(const Columns<double, 3, 3>& equations, InstructionSet set) {
  dispatch<RAYPROOF_BUILT_FOR>(equations, set);
}

}  // namespace rayproof
