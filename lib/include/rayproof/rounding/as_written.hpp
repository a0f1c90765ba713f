/// \file
/// From here on every operation is rounded as it is written, whatever the flags of the target that includes
/// this; rounding/as_before.hpp ends it. Included many times, so without a guard.
///
/// A compiler for a processor with fused multiply-adds may make a·b + c one operation with one rounding: g++
/// does so by default across statements, clang++ within one. The two triangles at an edge then no longer get
/// opposite signs, and an exact method's first guess is another. g++ before 13 also leaves out the rounding
/// from double to float where two stand side by side (docs/library.md). Between the two headers both are off.
/// clang++'s -ffp-contract=fast and anybody's -ffast-math disregard that. Where clang++ can't keep the
/// target's flags, on other processors than x86, its default is what counts from the end on.

// Without fused multiply-adds there is nothing to guard against, and g++ takes no function in line whose
// flags are not its caller's.
#if defined __clang__
#if defined __x86_64__ || defined __i386__
#pragma float_control(push)
#endif
#pragma clang fp contract(off)
#elif defined __GNUC__
#pragma GCC push_options
#if defined __FMA__ || defined __FMA4__ || !(defined __x86_64__ || defined __i386__)
#pragma GCC optimize("fp-contract=off")
#if __GNUC__ < 13
#pragma GCC optimize("no-tree-slp-vectorize")
#endif
#endif
#endif
