#pragma once
/// \file
/// The sizes of mistakes, by number: those of one number are alike to a few percent.

#include <cstddef>
#include <vector>

namespace rayproof::diagnosis {

/// The number of a size; that of 0 is a number of its own.
[[nodiscard]] std::size_t number_of_size(double size);
/// About the size of that number.
[[nodiscard]] double size_of_number(std::size_t number);
/// Whether a size is that of the number, or next to it.
[[nodiscard]] bool is_of_size(double size, std::size_t number);
/// The number to which most of the sizes belong; that of 0 where there is none.
[[nodiscard]] std::size_t usual_size(const std::vector<double>& sizes);
/// The mean of those; 0 where there is none.
[[nodiscard]] double mean_of_usual(const std::vector<double>& sizes);

}  // namespace rayproof::diagnosis
