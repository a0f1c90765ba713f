#include "properties/claims/robust_bound.hpp"

#include <rayproof/topics.hpp>

namespace rayproof {

std::optional<double> robust_bound(std::string_view topic) {
  std::optional<double> bound;
  Topics::for_each([&]<class Topic>(std::type_identity<Topic>) {
    if (topic == Topic::name) bound = Topic::robust_bound;
  });
  return bound;
}

}  // namespace rayproof
