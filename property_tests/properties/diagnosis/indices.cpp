#include "properties/diagnosis/indices.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace rayproof::diagnosis {

Indices all_of(std::size_t count) {
  Indices all(count);
  std::iota(all.begin(), all.end(), 0);
  return all;
}

Indices without(const Indices& some, const Indices& others) {
  Indices rest;
  std::ranges::set_difference(some, others, std::back_inserter(rest));
  return rest;
}

Indices common(const Indices& a, const Indices& b) {
  Indices both;
  std::ranges::set_intersection(a, b, std::back_inserter(both));
  return both;
}

Indices united(const Indices& a, const Indices& b) {
  Indices all;
  std::ranges::set_union(a, b, std::back_inserter(all));
  return all;
}

}  // namespace rayproof::diagnosis
