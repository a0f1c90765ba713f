#pragma once
/// \file
/// Words on standard error.

#include <fmt/format.h>

#include <cstdio>
#include <iterator>
#include <utility>

namespace rayproof {

/// Prints as fmt::print does. Where standard error cannot be written (a full disk), the words are lost, and
/// nothing else is: fmt::print would throw, and end the program in place of its work.
template <class... Arguments>
void print_to_stderr(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  fmt::memory_buffer words;
  fmt::format_to(std::back_inserter(words), format, std::forward<Arguments>(arguments)...);
  (void)std::fwrite(words.data(), 1, words.size(), stderr);
}

}  // namespace rayproof
