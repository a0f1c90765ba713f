#pragma once
/// \file
/// `rayproof walk --movie`: walkthroughs as a film.

#include <string>
#include <vector>

#include "viz/programs/walk/walks.hpp"

namespace rayproof::viz {

/// Writes a film of all walkthroughs, one after another; after Ctrl-C there is none, and a file of that name
/// is as it was. Throws WrongCommand for a name that is not of such a film or where there is no VTK,
/// std::runtime_error with one sentence where the file can't be written.
void write_movie(const std::vector<Walk>& walks, const std::string& path, ProgressLine& progress);

}  // namespace rayproof::viz
