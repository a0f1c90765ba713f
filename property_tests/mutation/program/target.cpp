#include "mutation/program/target.hpp"

#include <algorithm>
#include <bit>

#include "generators/generators.hpp"
#include "generators/random.hpp"
#include "programs/check/corpus.hpp"
#include "properties/hunt.hpp"
#include "properties/plan.hpp"

namespace rayproof::mutation {

namespace {

/// One of the families at a precision, and where its cases begin.
struct SeededFamily {
  const Family* family;
  Precision precision;
  std::uint64_t seed;
};

std::vector<SeededFamily> sources_of(const std::string& topic) {
  std::vector<SeededFamily> sources;
  for (const Family& family : families())
    if (family.topic == topic)
      for (const Precision precision : {Precision::float32, Precision::float64})
        // As engine.cpp does in its first round.
        sources.push_back(
            {&family, precision, seed_of_first_block(family, precision, combine(Settings{}.seed, 0))});
  return sources;
}

bool is_identical(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
bool is_identical(const std::optional<glm::dvec3>& a, const std::optional<glm::dvec3>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return is_identical(a->x, b->x) && is_identical(a->y, b->y) && is_identical(a->z, b->z);
}
bool is_identical(const RayAnswer& a, const RayAnswer& b) {
  const auto same_t = [](double x, double y) { return is_identical(x, y); };
  return a.contact == b.contact && a.nearest_only == b.nearest_only &&
         std::ranges::equal(a.hits.view(), b.hits.view(), same_t) && is_identical(a.point, b.point) &&
         is_identical(a.normal, b.normal) && is_identical(a.barycentric, b.barycentric);
}
bool is_identical(const QuadraticAnswer<double>& a, const QuadraticAnswer<double>& b) {
  return a.kind == b.kind && a.count == b.count && is_identical(a.roots[0], b.roots[0]) &&
         is_identical(a.roots[1], b.roots[1]);
}
bool is_identical(Position a, Position b) { return a == b; }

/// Bit for bit, -0 and 0 apart.
bool is_identical(const Answer& a, const Answer& b) {
  const auto compare = []<class A, class B>(const A& x, const B& y) {
    if constexpr (std::is_same_v<A, B>)
      return is_identical(x, y);
    else
      return false;
  };
  return std::visit(compare, a, b);
}

}  // namespace

std::vector<Input> inputs_of(const Subject& subject, unsigned first, unsigned last) {
  std::vector<Input> inputs;
  if (first == 0)
    for (Case& one : check::read_corpus(""))
      if (topic_of(one) == subject.topic) inputs.push_back({std::move(one)});
  const std::vector<SeededFamily> sources = sources_of(subject.topic);
  for (unsigned k = first; k < last; ++k)
    for (const auto& [family, precision, seed] : sources)
      inputs.push_back({family->generate(combine(seed, k), precision), k, family->name.c_str()});
  return inputs;
}

Judged judged(const Subject& subject, const Input& input) {
  Answer answer = subject.answer(input.one);
  const oracle::Judgement judgement = oracle::judge(input.one, answer);
  return {std::move(answer), judgement};
}

const Property* broken_by(const Subject& subject, const Input& input, const Judged& known) {
  Trial trial(subject, input.one);
  if (is_identical(trial.claimed(), known.answer)) trial.recall(known.answer, known.judgement);
  for (const Property& property : properties())
    if (claims(subject, property) && input.k % property.every == 0 && property.rule(trial) == Ruling::broken)
      return &property;
  return nullptr;
}

}  // namespace rayproof::mutation
