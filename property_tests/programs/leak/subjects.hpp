#pragma once
/// \file
/// Who is on trial in rayproof leak.

#include <memory>

#include "programs/leak/options.hpp"

namespace rayproof::leaks {

/// The subjects that are asked, our methods first.
struct SubjectPanel {
  std::vector<std::unique_ptr<Subject>> guests{};
  std::vector<const Subject*> all{};
};

/// Our methods: those that are named; where nobody is named at all, all but those printed wrongly. Then the
/// programs. Throws std::runtime_error with a sentence for a name that nobody has.
[[nodiscard]] SubjectPanel panel_of(const LeakOptions& options);

}  // namespace rayproof::leaks
