#include "viz/walkthrough/magnifier.hpp"

#include <fmt/format.h>

#include <cmath>

#include "viz/walkthrough/live_values.hpp"

namespace rayproof::viz {

Items dots_of(const Magnifier& magnifier, double around, Precision precision) {
  Items items;
  for (const int next : {-1, 1}) {
    double t = next > 0 ? neighbour_of(around, next, precision) : around;
    for (int i = 0; i < 8 && std::abs(t - magnifier.centre) <= magnified_reach * magnifier.unit; ++i) {
      items.push_back(point(Role::muted, magnifier.at(t)));
      t = neighbour_of(t, next, precision);
    }
  }
  return items;
}

std::string dots_in_words(Precision precision) {
  return fmt::format("Each dot is a {} value.", name_of(precision));
}

}  // namespace rayproof::viz
