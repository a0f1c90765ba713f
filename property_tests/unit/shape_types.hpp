#pragma once
/// \file
/// The shapes of the case format for tests that run over all of them.

#include <string>
#include <vector>

#include "case/reader/shape_reader.hpp"
#include "generators/number_by_number.hpp"

namespace rayproof {

/// The types of the shapes, which are their topics, each once.
[[nodiscard]] inline std::vector<std::string> ray_topics() {
  return []<class... S>(std::type_identity<std::variant<S...>>) {
    return detail::list_of_types<S...>();
  }(std::type_identity<Shape>{});
}

/// A ray and a shape of the topic, in any of its forms, drawn number by number.
template <class Number>
[[nodiscard]] RayQuestion question_of_topic(const std::string& topic, Random& random, Number&& number) {
  using Make = RayQuestion (*)(Random&, Number&);
  std::vector<Make> forms;
  const auto add = [&]<class S>(std::type_identity<S>) {
    if (topic == ShapeFormat<S>::type)
      forms.push_back([](Random& r, Number& n) { return from_numbers<S>(r, n); });
  };
  [&]<class... S>(std::type_identity<std::variant<S...>>) {
    (add(std::type_identity<S>{}), ...);
  }(std::type_identity<Shape>{});
  const int last = static_cast<int>(forms.size()) - 1;
  return first_accepted([&] {
    return forms.at(static_cast<std::size_t>(last <= 0 ? 0 : random.between(0, last)))(random, number);
  });
}

}  // namespace rayproof
