#include "properties/diagnosis/question.hpp"

#include <algorithm>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/changes.hpp"

namespace rayproof::diagnosis {
namespace {

bool is_at_end(const AnsweredCase& asked) {
  const RayQuestion* question = ray_question(asked.one);
  return question != nullptr && std::ranges::any_of(numbers_in(asked.exact), [&](double t) {
           return t == question->ray.t_min || t == question->ray.t_max;
         });
}

}  // namespace

AnsweredCase::AnsweredCase(Case asked) : one(std::move(asked)), exact(oracle::answer(one)) {}

bool is_same_question(const AnsweredCase& a, const AnsweredCase& b, Keeps keeps) {
  if (finds_something(a.exact) != finds_something(b.exact)) return false;
  if (keeps == Keeps::verdict) return true;
  if (const auto* position = std::get_if<Position>(&a.exact)) return *position == std::get<Position>(b.exact);
  if (const auto* roots = std::get_if<QuadraticAnswer<double>>(&a.exact))
    return roots->kind == std::get<QuadraticAnswer<double>>(b.exact).kind;
  return std::get<RayAnswer>(a.exact).contact == std::get<RayAnswer>(b.exact).contact &&
         numbers_in(a.exact).size() == numbers_in(b.exact).size() && is_at_end(a) == is_at_end(b);
}

bool is_on_boundary(const AnsweredCase& one) {
  if (const auto* position = std::get_if<Position>(&one.exact)) return *position == Position::boundary;
  if (const auto* roots = std::get_if<QuadraticAnswer<double>>(&one.exact))
    return roots->kind == RootKind::twice;
  const auto& answer = std::get<RayAnswer>(one.exact);
  const bool is_regular = answer.contact == Contact::crossing || answer.contact == Contact::none ||
                          answer.contact == Contact::parallel;
  return !is_regular || is_at_end(one) || (answer.hits.count > 0 && !answer.normal);
}

}  // namespace rayproof::diagnosis
