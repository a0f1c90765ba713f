#include "viz/walkthrough/magnifier.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace rayproof::viz {

double neighbour(double x, double toward, Precision precision) {
  return precision == Precision::float32
             ? static_cast<double>(std::nextafter(static_cast<float>(x), static_cast<float>(toward)))
             : std::nextafter(x, toward);
}

Items dots_of(const Magnifier& magnifier, double around, Precision precision) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Items items;
  for (const double toward : {-infinite, infinite}) {
    double t = toward > 0 ? neighbour(around, infinite, precision) : around;
    for (int i = 0; i < 8 && std::abs(t - magnifier.centre) <= magnified_reach * magnifier.unit; ++i) {
      items.push_back(point(Role::muted, magnifier.at(t)));
      t = neighbour(t, toward, precision);
    }
  }
  return items;
}

std::string dots_in_words(Precision precision) {
  return fmt::format("Each dot is a {} value.", name_of(precision));
}

}  // namespace rayproof::viz
