#include "oracle/oracle.hpp"

#include "oracle/judge/judging.hpp"
#include "oracle/shapes/shapes.hpp"

namespace rayproof::oracle {

static RayAnswer answer(const RayQuestion& question, Precision precision) {
  return std::visit([&](const auto& shape) { return answer(*intersection_of(question, shape), precision); },
                    question.shape);
}

/// The judge of every shape that has none of its own.
template <class Shape>
static Judgement judge(const RayQuestion& question, const Shape& shape, Precision precision,
                       const RayAnswer& claimed) {
  return filtered([&] { return judge(*intersection_of(question, shape), precision, claimed); });
}
static Judgement judge(const RayQuestion& question, Precision precision, const RayAnswer& claimed) {
  return std::visit([&](const auto& shape) { return judge(question, shape, precision, claimed); },
                    question.shape);
}

Answer answer(const Case& one) {
  return std::visit([&](const auto& question) -> Answer { return answer(question, one.precision); },
                    one.question);
}

Details judge_details(const Case& one, const Answer& claimed) {
  const auto* question = std::get_if<RayQuestion>(&one.question);
  if (question == nullptr) return {};
  const auto judge_as = [&](const auto& shape) {
    return judge_details(*intersection_of(*question, shape), one.precision, std::get<RayAnswer>(claimed));
  };
  return std::visit(judge_as, question->shape);
}

Judgement judge(const Case& one, const Answer& claimed) {
  const auto judge_as = [&](const auto& question) {
    using Expected = decltype(answer(question, one.precision));
    const auto& expected = std::get<Expected>(claimed);
    if constexpr (std::is_same_v<Expected, RayAnswer>) return judge(question, one.precision, expected);
    return filtered([&] { return judge(question, one.precision, expected); });
  };
  return std::visit(judge_as, one.question);
}

}  // namespace rayproof::oracle
