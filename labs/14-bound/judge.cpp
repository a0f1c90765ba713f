#include "answer_questions.hpp"
#include "bound.hpp"

int main() {
  return rayproof::answer_questions([](float a, float b, float c, float d) {
    const auto [value, error] = bound(a, b, c, d);
    return std::array<double, 2>{value, error};
  });
}
