#pragma once
#include <string>

namespace rayproof::check {

/// Puts each finding of the file to its subject and property again, and each bare case to every subject of
/// its topic under all they claim; says of each whether it still breaks. Returns the exit status: 0 where
/// nothing that is claimed breaks and everything declared broken still does.
[[nodiscard]] int replay(const std::string& file);

}  // namespace rayproof::check
