#pragma once
/// \file
/// Any program as a subject: a shell line that reads cases and writes answers (docs/case-format.md).

#include <chrono>
#include <string>
#include <vector>

#include "subjects/program/program.hpp"
#include "subjects/subject.hpp"

namespace rayproof {

/// How long a program may be silent while a case waits, in seconds, at least and at most.
inline constexpr double least_case_seconds = 0.01, most_case_seconds = 3600;

/// The name of a subject made of a command that the user gave: "sphere/command".
inline constexpr const char* command_name = "command";

/// How long a command may be silent while a case waits, where nobody says otherwise.
inline constexpr std::chrono::milliseconds usual_case_time{2000};

/// A command as a subject of every topic, under what its users expect of it (default_contract.hpp). All of
/// them share its processes, and give no more answers once `stop` is true. Instances throw
/// program::CannotStart where the shell finds nothing to start.
[[nodiscard]] std::vector<Subject> subjects_of_command(const std::string& name, const std::string& command,
                                                       std::chrono::milliseconds case_time,
                                                       const std::atomic<bool>* stop = nullptr);

}  // namespace rayproof
