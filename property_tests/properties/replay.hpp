#pragma once
/// \file
/// Findings and cases judged again.

#include <string>

namespace rayproof {

/// Puts each finding of the file to its subject and property again, and each bare case to every subject of
/// its topic under all they claim; prints of each whether it still breaks. Returns the exit status: 0 where
/// nothing that is claimed breaks and everything declared broken still does. Throws std::runtime_error where
/// the file can't be read.
[[nodiscard]] int replay_file(const std::string& file);

/// The same for one finding of a run, by its number. Throws UnreadableCase.
[[nodiscard]] int replay_finding(const std::string& file, std::size_t number);

}  // namespace rayproof
