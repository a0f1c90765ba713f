"""The instruction sets that the batch kernels are built for."""

import sys

from markdown import section

PROGRAM = """#include <cstdio>
#include <exception>
#include <rayproof/batch.hpp>
int main() try {
  for (const auto set : rayproof::available_instruction_sets()) std::puts(name_of(set).data());
} catch (const std::exception& refusal) {
  std::puts(refusal.what());
}
"""
UNKNOWN = "RAYPROOF_INSTRUCTION_SETS: there is no 'avx3'"
ELSEWHERE = "the batch kernels were built for another machine (RAYPROOF_INSTRUCTION_SETS)"
CONFIGURE = "cmake -S . -B build/sets -DRAYPROOF_LAB=OFF -DRAYPROOF_INSTRUCTION_SETS="


def sets(place):
    """A build has the kernels that were asked for and no others, says where its machine lacks them, and refuses a set that
    there is not. The manual names the choices."""
    if UNKNOWN not in " ".join(place.run(f"{CONFIGURE}avx3 2>&1 || true", place.checkout).split()):
        sys.exit(f"CMake does not say '{UNKNOWN}'")
    place.run(f"{CONFIGURE}avx2 && cmake --build build/sets --parallel", place.checkout)
    program = place.work / "sets"
    ended = place.compile(PROGRAM, str(place.checkout / "build/sets/lib/librayproof.a"), "-o", str(program))
    if ended.returncode != 0:
        sys.exit(ended.stderr)
    has_avx2 = "#define __AVX2__" in place.compile("", "-march=native", "-dM", "-E").stdout
    said = place.run(str(program), place.work).strip()
    if said != ("avx2" if has_avx2 else ELSEWHERE):
        sys.exit(f"built for AVX2 alone, on a machine {'with' if has_avx2 else 'without'} it, it says: {said}")
    if "`RAYPROOF_INSTRUCTION_SETS`" not in section(place.manual, "Batches"):
        sys.exit("the manual does not name the option")
