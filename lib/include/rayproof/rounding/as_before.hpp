/// \file
/// Ends what rounding/as_written.hpp began: from here on the target's own flags count again.

#if defined __clang__
#pragma float_control(pop)
#elif defined __GNUC__
#pragma GCC pop_options
#endif
