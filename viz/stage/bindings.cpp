#include <cmath>
#include <map>

#include "viz/stage/bindings.hpp"

namespace rayproof::viz {

const std::vector<Binding>& bindings_of(const std::string& topic) {
  static const std::map<std::string, std::vector<Binding>> tables{
      {"sphere", sphere_bindings()},
  };
  static const std::vector<Binding> none;
  const auto found = tables.find(topic);
  return found == tables.end() ? none : found->second;
}

Items answer_item(const NumbersByName& n, const std::string& name) {
  if (name != "t" && name != "t₀" && name != "t₁" && name != "t_entry" && name != "t_exit") return {};
  return {point(Role::claimed, n.at(n.rounded(name)), name)};
}

}  // namespace rayproof::viz
