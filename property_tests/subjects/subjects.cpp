/// \file
/// The registration of the subjects' layer: every topic of the library, and one line for each guest.

#include "subjects/our_subject.hpp"

namespace rayproof {

Subject glm_sphere();

const std::vector<Subject>& subjects() {
  static const std::vector<Subject> all = [] {
    std::vector<Subject> list;
    Topics::for_each([&]<class Topic>(std::type_identity<Topic>) {
      Topic::Methods::for_each(
          [&]<class Method>(std::type_identity<Method>) { list.push_back(our_subject<Topic, Method>()); });
    });
    list.push_back(glm_sphere());
    return list;
  }();
  return all;
}

const Subject* find_subject(const std::string& full_name) {
  for (const Subject& subject : subjects()) {
    if (subject.full_name() == full_name) return &subject;
  }
  return nullptr;
}

}  // namespace rayproof
