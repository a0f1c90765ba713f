#pragma once
/// \file
/// Programs on trial: what rayproof check does and prints where the subjects are not ours.

#include <functional>
#include <vector>

#include "programs/check/options.hpp"
#include "subjects/subject.hpp"

namespace rayproof::check {

/// The program of --subject-command as a subject of every topic that the settings want. Throws UnknownName.
[[nodiscard]] std::vector<Subject> subjects_of(const Options& options);

/// Asks each subject of the plan what its answers hold.
void learn_all(std::vector<Subject>& guests, const Settings& settings,
               const std::function<void(double)>& progress);

}  // namespace rayproof::check
