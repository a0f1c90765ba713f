#pragma once
/// \file
/// The arithmetic that stands in for real numbers in walkthroughs and pictures.

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstdint>

namespace rayproof::viz {

/// 320 significant bits (267 more than double) and an exponent range that no product of doubles leaves.
using Shadow = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<320, boost::multiprecision::digit_base_2, void, std::int32_t>,
    boost::multiprecision::et_off>;

}  // namespace rayproof::viz
