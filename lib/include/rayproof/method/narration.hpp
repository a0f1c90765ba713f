#pragma once
/// \file
/// A kernel explains itself: `step` and `named` stand where a comment would.
///
/// In the plain arithmetics and in packs they vanish. In the recording arithmetic (arithmetics/recorded.hpp)
/// they become the steps, labels and values that `rayproof explain` prints and the walkthroughs show.

#include <cstddef>
#include <string_view>

namespace rayproof {

/// A step that several kernels share, written once: what `step` takes.
struct Step {
  std::string_view title;
  std::string_view meaning;

  template <std::size_t N>
  requires(N > 1) constexpr Step(std::string_view its_title, const char (&its_meaning)[N])
      : title(its_title), meaning(its_meaning) {}
};

/// Receives the steps of a kernel run in arithmetic `T`; an arithmetic that listens specialises it.
template <class T>
struct Narrator {
  static constexpr void step(const Step& /*step*/) {}
};

template <class T>
constexpr void step(const Step& shared) {
  Narrator<T>::step(shared);
}

/// Begins a step of the kernel: its title in the imperative, "Find the ray point nearest the centre", and in
/// a sentence what it does geometrically and why. A {name} in the sentence stands for the number of that
/// name.
template <class T, std::size_t N>
requires(N > 1) constexpr void step(std::string_view title, const char (&meaning)[N]) {
  step<T>(Step(title, meaning));
}

/// Gives a number or vector the name it has in the formula, and passes it on unchanged.
template <class V>
[[nodiscard]] constexpr V named(const char* /*name*/, V value) {
  return value;
}

}  // namespace rayproof
