/// \file
/// One method of the library as a shared object: all that has to be compiled again for a mutant.
///
/// RAYPROOF_TOPIC is the namespace of the topic, RAYPROOF_METHOD the method's name in the listings.

#include <string_view>

#include "subjects/our_subject.hpp"
#include "subjects/reading.hpp"

#ifndef RAYPROOF_TOPIC
#define RAYPROOF_TOPIC sphere
#define RAYPROOF_METHOD "centred"
#endif

namespace rayproof {

/// The batch kernels are compiled into the library, where no mutant is.
struct Unbatched : RAYPROOF_TOPIC::Topic {
  static constexpr bool is_batched = false;
};

template <>
struct Reading<Unbatched> : Reading<RAYPROOF_TOPIC::Topic> {};

}  // namespace rayproof

extern "C" __attribute__((visibility("default"))) void rayproof_add_subject(
    std::vector<rayproof::Subject>& subjects) {
  using namespace rayproof;
  Unbatched::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
    if constexpr (std::string_view(Method::name) == RAYPROOF_METHOD)
      subjects.push_back(our_subject<Unbatched, Method>());
  });
}
