/// \file
/// Ends what rounding/as_written.hpp began: from here on the target's own flags count again.

#if defined __clang__
#if defined __x86_64__ || defined __i386__
#pragma float_control(pop)
#else
#pragma clang fp contract(on)
#endif
#elif defined __GNUC__
#pragma GCC pop_options
#endif
