/// \file
/// rayproof-check-mutants: runs the mutants of one method through the cases of `rayproof check`, one process
/// each.
///
/// The method comes from a shared object with all mutants in it (target.hpp). All else in the program,
/// the oracle above all, is rayproof-check's own, compiled from the library as it is: the mutated templates
/// are hidden in their shared object, so that a mutant changes the accused and never the judge.

#include <dlfcn.h>
#include <fmt/format.h>

#include <iostream>
#include <stdexcept>

#include "case/print_to_stderr.hpp"
#include "case/writer.hpp"
#include "mutation/program/mutant_run.hpp"
#include "mutation/program/notes.hpp"
#include "mutation/program/target.hpp"

namespace {

using namespace rayproof;
using namespace rayproof::mutation;

template <class Function>
Function symbol(void* object, const char* name) {
  void* found = dlsym(object, name);
  if (found == nullptr) throw std::runtime_error(dlerror());
  return reinterpret_cast<Function>(found);
}

/// Never closed: the subjects point into it.
void* load(const std::string& path) {
  void* object = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (object == nullptr) throw std::runtime_error(dlerror());
  return object;
}

std::vector<Subject> subjects_in(void* object) {
  std::vector<Subject> subjects;
  symbol<void (*)(std::vector<Subject>&)>(object, "rayproof_add_subjects")(subjects);
  return subjects;
}

/// The method of that name in the shared object.
Target find(void* object, const std::string& method) {
  for (const Subject& subject : subjects_in(object))
    if (subject.full_name() == method)
      return {subject, *symbol<State* (*)()>(object, "rayproof_mutation_state")()};
  throw std::runtime_error("there is no method " + method);
}

int run(const Target& target, const std::vector<Input>& inputs) {
  std::vector<int> mutants;
  for (int number = 0; std::cin >> number;) mutants.push_back(number);
  const Notes notes = note_all(target, inputs, mutants);
  if (notes.broken) {
    fmt::print("{{\"unmutated\": \"{}\", \"case\": {}}}\n", notes.broken->name,
               write_case(notes.broken_in->one));
    return 1;
  }
  for (const int number : mutants) {
    const MutantResult result = try_mutant(target, inputs, notes, number);
    fmt::print("{}\n", as_json(number, notes, result, inputs));
    std::fflush(stdout);
  }
  return 0;
}

unsigned number_in(const std::string& text) { return static_cast<unsigned>(std::stoul(text)); }

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 4 && argc != 5) {
    print_to_stderr(
        "rayproof-check-mutants OBJECT: the methods in it, a line each\n"
        "rayproof-check-mutants OBJECT METHOD FIRST LAST < NUMBERS: the mutants of these numbers on "
        "cases FIRST to LAST - 1\n"
        "rayproof-check-mutants OBJECT METHOD FILE < NUMBERS: on the cases of a file\n");
    return 2;
  }
  try {
    void* const object = load(argv[1]);
    if (argc == 2) {
      for (const Subject& subject : subjects_in(object)) fmt::print("{}\n", subject.full_name());
      return 0;
    }
    const Target target = find(object, argv[2]);
    return run(target, argc == 4 ? inputs_of(target.subject, argv[3])
                                 : inputs_of(target.subject, number_in(argv[3]), number_in(argv[4])));
  } catch (const std::exception& trouble) {
    print_to_stderr("rayproof-check-mutants: {}\n", trouble.what());
    return 2;
  }
}
