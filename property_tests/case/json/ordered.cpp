#include "case/json/ordered.hpp"

namespace rayproof {

nlohmann::ordered_json read_json(std::string_view text, bool throws) {
  return nlohmann::ordered_json::parse(text, nullptr, throws);
}

std::string write_json(const nlohmann::ordered_json& json, int indent) {
  // The name of a file may have bytes that are no UTF-8.
  return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace rayproof
