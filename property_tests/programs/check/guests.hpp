#pragma once
/// \file
/// Programs on trial: what rayproof check does and prints where the subjects are not ours.

#include <functional>
#include <vector>

#include "programs/check/options.hpp"
#include "properties/guests/probe.hpp"

namespace rayproof::check {

/// The programs of --subject-command and --subject as subjects of every topic that the settings want. Throws
/// UnknownName.
[[nodiscard]] std::vector<Subject> subjects_of(const Options& options);

/// Asks each guest what its answers hold; gives the cases that it did not answer.
[[nodiscard]] std::vector<Failure> learn_all(std::vector<Subject>& guests, const Settings& settings,
                                             const std::function<void(double)>& progress);

}  // namespace rayproof::check
