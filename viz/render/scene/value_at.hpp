#pragma once
/// \file
/// What stands at a field of a document, for a sentence about it.

#include <string>
#include <string_view>

#include "case/json/text.hpp"

namespace rayproof::render {

/// The text at a path as `Field::path` writes it ("shapes[3].shape.radius"), shortened where it is long;
/// empty for an object, and where nothing stands there.
[[nodiscard]] std::string value_at(const json::Document& document, std::string_view path);

}  // namespace rayproof::render
