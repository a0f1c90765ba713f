/// \file
/// The methods of a topic as a shared object, compiled from headers with all their mutants in them.
///
/// RAYPROOF_TOPIC is the namespace of the topic.

#include "mutation/planted/planting.hpp"
#include "subjects/our_subject.hpp"
#include "subjects/reading.hpp"

#ifndef RAYPROOF_TOPIC
#define RAYPROOF_TOPIC sphere
#endif

namespace rayproof {

/// The batch kernels are compiled into the library, where no mutant is.
struct Unbatched : RAYPROOF_TOPIC::Topic {
  static constexpr bool is_batched = false;
};

template <>
struct Reading<Unbatched> : Reading<RAYPROOF_TOPIC::Topic> {};

}  // namespace rayproof

extern "C" __attribute__((visibility("default"))) rayproof::mutation::State* rayproof_mutation_state() {
  return &rayproof::mutation::state;
}

extern "C" __attribute__((visibility("default"))) void rayproof_add_subjects(
    std::vector<rayproof::Subject>& subjects) {
  using namespace rayproof;
  Unbatched::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
    if constexpr (Method::contract.standing != Standing::printed)
      subjects.push_back(our_subject<Unbatched, Method>());
  });
}
