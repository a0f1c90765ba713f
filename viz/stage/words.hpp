#pragma once
/// \file
/// What there is to see in a kernel's step, by the step's title.

#include <functional>
#include <string>

namespace rayproof::viz {

/// One sentence, or nothing for a step that needs none; with the numbers put in where the step itself names
/// none. `number_of` tells the number of a name, or nothing where the kernel has no such name.
[[nodiscard]] std::string words_for(const std::string& title,
                                    const std::function<std::string(const std::string& name)>& number_of);

}  // namespace rayproof::viz
