#pragma once
/// \file
/// What the program of a library says of it, and how it asked it a case (peers/reproduction.hpp).

#include <chrono>
#include <map>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace rayproof::dossier {

/// A library as its program introduces it.
struct LibraryFacts {
  std::string name{};
  std::string version{};
  std::string build{};  ///< the shell line that builds and runs a reproduction
  std::string tracker{};
  /// What its documentation says of some faults: words of "property: diagnosis", and a sentence.
  std::vector<std::pair<std::string, std::string>> documented{};
  [[nodiscard]] bool is_javascript() const { return build.find("node ") != std::string::npos; }
};

/// Numbers by their names, vectors and lists one number after another.
using NamedNumbers = std::map<std::string, std::vector<double>>;

/// How the library was asked one case.
struct Reproduction {
  std::string function{};  ///< "glm::intersectRaySphere"
  std::string source{};    ///< a whole program in the library's language
  NamedNumbers inputs{};
  bool has_returned = false;
  std::string printed{};  ///< what that program prints
  NamedNumbers said{};
  std::string ending{};  ///< how it ended, where the library did not return
};

/// Asks the program that the shell line starts. Throws std::runtime_error where it does not say.
[[nodiscard]] LibraryFacts facts_of(const std::string& command);

/// Throws std::runtime_error where the program does not show how it asks, as where the case is not for it.
[[nodiscard]] Reproduction reproduction_of(const std::string& command, const Case& one,
                                           std::chrono::milliseconds patience);

}  // namespace rayproof::dossier
