#include "case/case.hpp"

#include <type_traits>

namespace rayproof {

std::string topic_of(const Case& one) {
  const auto* const question = std::get_if<RayQuestion>(&one.question);
  if (question == nullptr) return "quadratic";
  return std::visit(
      [](const auto& shape) -> std::string { return ShapeFormat<std::decay_t<decltype(shape)>>::type; },
      question->shape);
}

}  // namespace rayproof
