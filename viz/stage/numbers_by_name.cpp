#include "viz/stage/numbers_by_name.hpp"

#include <limits>

namespace rayproof::viz {
namespace {

double find(const std::map<std::string, double>& numbers, const std::string& name) {
  const auto found = numbers.find(name);
  return found == numbers.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
}

}  // namespace

NumbersByName::NumbersByName(const Walkthrough& walk, std::size_t last_step) {
  for (const WalkValue& value : walk.inputs) take(value);
  for (std::size_t i = 0; i <= last_step && i < walk.steps.size(); ++i) {
    for (const WalkValue& value : walk.steps[i].values) take(value);
  }
}

void NumbersByName::take(const WalkValue& value) {
  first_.try_emplace(value.name, value.exact_value);
  exact_[value.name] = value.exact_value;
  rounded_[value.name] = value.value;
}

double NumbersByName::operator[](const std::string& name) const { return find(exact_, name); }
double NumbersByName::rounded(const std::string& name) const { return find(rounded_, name); }

glm::dvec3 NumbersByName::vector(const std::string& name) const {
  const auto component = [&](const char* suffix) {
    return has(name + suffix) ? (*this)[name + suffix] : 0.0;
  };
  return {component(".x"), component(".y"), component(".z")};
}

glm::dvec3 NumbersByName::first_vector(const std::string& name) const {
  return {find(first_, name + ".x"), find(first_, name + ".y"), find(first_, name + ".z")};
}

glm::dvec3 NumbersByName::origin() const { return first_vector(has_vector("o′") ? "o′" : "o"); }

// A plane has a d of its own; beside it the direction bears an arrow. A kernel may name a d of its own later.
glm::dvec3 NumbersByName::direction() const { return first_vector(has_vector("d⃗") ? "d⃗" : "d"); }

}  // namespace rayproof::viz
