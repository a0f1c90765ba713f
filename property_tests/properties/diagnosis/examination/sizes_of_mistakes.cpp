#include "properties/diagnosis/examination/sizes_of_mistakes.hpp"

#include <algorithm>
#include <cmath>

namespace rayproof::diagnosis {
namespace {

constexpr double step = 1.0 / 64;  // of the logarithm: 1.6 %
constexpr long of_one = 1L << 16;  // beyond the logarithm of the smallest number

}  // namespace

std::size_t number_of_size(double size) {
  if (size == 0 || !std::isfinite(size)) return 0;
  const long place = std::lround(std::log(std::abs(size)) / step) + of_one;
  return 2 * static_cast<std::size_t>(place) + (size < 0 ? 1 : 0);
}

double size_of_number(std::size_t number) {
  if (number == 0) return 0;
  const double size = std::exp(step * (static_cast<double>(number / 2) - of_one));
  return number % 2 == 1 ? -size : size;
}

bool is_of_size(double size, std::size_t number) {
  const std::size_t own = number_of_size(size);
  if (own == 0 || number == 0) return false;
  return own % 2 == number % 2 && std::max(own, number) - std::min(own, number) <= 2;
}

std::size_t usual_size(const std::vector<double>& sizes) {
  std::size_t best = 0;
  std::ptrdiff_t most = 0;
  for (const double size : sizes) {
    const std::size_t number = number_of_size(size);
    const auto count =
        std::ranges::count_if(sizes, [number](double other) { return is_of_size(other, number); });
    if (count <= most) continue;
    most = count;
    best = number;
  }
  return best;
}

double mean_of_usual(const std::vector<double>& sizes) {
  const std::size_t usual = usual_size(sizes);
  double sum = 0, count = 0;
  for (const double size : sizes) {
    if (!is_of_size(size, usual)) continue;
    sum += size;
    count += 1;
  }
  return count > 0 ? sum / count : 0;
}

}  // namespace rayproof::diagnosis
