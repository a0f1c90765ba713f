#include "mutation/program/target.hpp"

#include "generators/generators.hpp"
#include "generators/random.hpp"
#include "mutation/program/transcript.hpp"
#include "programs/check/corpus.hpp"
#include "properties/engine/hunt.hpp"
#include "properties/engine/plan.hpp"

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

}  // namespace

std::vector<Input> inputs_of(const Subject& subject, const std::string& file) {
  std::vector<Input> inputs;
  for (Case& one : check::read_corpus(file))
    if (topic_of(one) == subject.topic) inputs.push_back({std::move(one)});
  return inputs;
}

std::vector<Input> inputs_of(const Subject& subject, unsigned first, unsigned last) {
  std::vector<Input> inputs;
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
