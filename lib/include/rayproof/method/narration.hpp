#pragma once
/// \file
/// A kernel tells its own story: `step` and `named` stand where a comment would.
///
/// In the plain arithmetics and in packs they vanish. In the recording arithmetic (arithmetics/recorded.hpp)
/// they become the steps, labels and values that `rayproof explain` prints and the walkthroughs show.

namespace rayproof {

/// Receives the steps of a kernel run in arithmetic `T`; an arithmetic that listens specialises it.
template <class T>
struct Narrator {
  static constexpr void step(const char* /*title*/) {}
};

/// Begins a step of the kernel, titled in the imperative: "Find the ray point nearest the centre".
template <class T>
constexpr void step(const char* title) {
  Narrator<T>::step(title);
}

/// Gives a number or vector the name it has in the formula, and passes it on unchanged.
template <class V>
[[nodiscard]] constexpr V named(const char* /*name*/, V value) {
  return value;
}

}  // namespace rayproof
