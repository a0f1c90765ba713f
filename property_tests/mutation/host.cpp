/// \file
/// The subjects of rayproof-check-mutant: one method, from the shared object that RAYPROOF_MUTANT names.
///
/// All else in the program is rayproof-check's own, compiled from the library as it is. The method's
/// templates are hidden in their shared object, so that a mutant changes the accused and never the judge.

#include <dlfcn.h>

#include <cstdlib>
#include <stdexcept>

#include "subjects/subject.hpp"

namespace rayproof {

namespace {

using AddSubject = void (*)(std::vector<Subject>&);

AddSubject loaded() {
  const char* path = std::getenv("RAYPROOF_MUTANT");
  if (path == nullptr) throw std::runtime_error("RAYPROOF_MUTANT names no shared object with a method");
  // Never closed: the subjects point into it.
  void* object = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (object == nullptr) throw std::runtime_error(dlerror());
  void* symbol = dlsym(object, "rayproof_add_subject");
  if (symbol == nullptr) throw std::runtime_error(dlerror());
  return reinterpret_cast<AddSubject>(symbol);
}

}  // namespace

const std::vector<Subject>& subjects() {
  static const std::vector<Subject> all = [] {
    std::vector<Subject> list;
    loaded()(list);
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
