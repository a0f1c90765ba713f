#include "viz/scene/items.hpp"

#include <stdexcept>

namespace rayproof::viz {
namespace {

double find(const std::map<std::string, double>& numbers, const std::string& name) {
  const auto found = numbers.find(name);
  if (found == numbers.end()) throw std::logic_error("no kernel of this run names " + name);
  return found->second;
}

}  // namespace

std::set<std::string> recorded_names(const Walkthrough& walk) {
  std::set<std::string> names;
  for (const WalkStep& step : walk.steps) {
    names.insert(step.title);
    for (const WalkValue& value : step.values) {
      names.insert(value.name);
      if (value.name.ends_with(".x")) names.insert(value.name.substr(0, value.name.size() - 2));
    }
  }
  return names;
}

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
  const auto in_space = [&](const std::string& component) {
    return has(component) ? (*this)[component] : 0.0;
  };
  return {(*this)[name + ".x"], (*this)[name + ".y"], in_space(name + ".z")};
}

glm::dvec3 NumbersByName::first_vector(const std::string& name) const {
  return {find(first_, name + ".x"), find(first_, name + ".y"), find(first_, name + ".z")};
}

glm::dvec3 NumbersByName::origin() const { return first_vector(has_vector("o′") ? "o′" : "o"); }

// A plane has a d of its own; beside it the direction bears an arrow. A kernel may name a d of its own later.
glm::dvec3 NumbersByName::direction() const { return first_vector("d"); }

}  // namespace rayproof::viz
