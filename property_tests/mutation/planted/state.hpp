#pragma once
/// \file
/// Which mutant is in force in a shared object.

namespace rayproof::mutation {

/// What a mutant comes to where it is met: nothing that compiles, the original's value, or another one.
enum class Meeting { no_mutant, same, other };
[[nodiscard]] constexpr Meeting meeting(bool differs) { return differs ? Meeting::other : Meeting::same; }

/// What the program that loaded the shared object sets, and is asked to note.
struct State {
  int chosen = -1;         ///< the mutant in force; -1 for the kernels as they are
  bool is_noting = false;  ///< call `note` for each mutant that is met
  void (*note)(int number, Meeting meeting) = nullptr;
};

}  // namespace rayproof::mutation
