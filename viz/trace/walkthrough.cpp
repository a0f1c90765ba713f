#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "viz/trace/numbers.hpp"
#include "viz/trace/record.hpp"

namespace rayproof::viz {
namespace {

std::vector<OperationId> operations_of_step(const Tape& tape, std::ptrdiff_t step) {
  std::vector<OperationId> operations;
  for (std::size_t i = 0; i < tape.operations.size(); ++i) {
    if (tape.operations[i].step == step) operations.push_back(static_cast<OperationId>(i));
  }
  return operations;
}

/// The operations of the number's own formula, itself first: from it back to numbers that have a name, to
/// inputs, and to earlier steps.
std::vector<OperationId> operations_of_value(const Tape& tape, OperationId value) {
  std::vector<OperationId> operations{value};
  for (std::size_t next = 0; next < operations.size(); ++next) {
    for (const OperationId id : tape.at(operations[next]).operands) {
      const bool is_part =
          id != unrecorded && tape.at(id).name.empty() && tape.at(id).step == tape.at(value).step;
      if (is_part) operations.push_back(id);
    }
  }
  return operations;
}

WalkValue value_of(const Tape& tape, OperationId id, const std::string& name) {
  const Operation<Shadow>& o = tape.at(id);
  const bool is_input = o.op == Operator::constant;
  WalkValue value;
  value.name = name;
  value.value = o.value;
  value.exact = exact_beside(o.exact, o.value, o.digits);
  value.exact_value = static_cast<double>(o.exact);
  value.error = static_cast<double>(Shadow(o.value) - o.exact);
  value.error_bound = o.error_bound;
  value.bits_lost = o.bits_lost;
  value.digits = o.digits;
  if (is_input) return value;
  value.formula = formula_of(tape, id);
  value.loss = worst_loss_of(tape, operations_of_value(tape, id), o.bits_lost);
  return value;
}

std::vector<WalkValue> named_values(const Tape& tape, const NamedValue& named) {
  if (named.components.size() == 1) return {value_of(tape, named.components[0], named.name)};
  std::vector<WalkValue> values;
  const char* suffix[] = {".x", ".y", ".z"};
  for (std::size_t i = 0; i < named.components.size(); ++i) {
    values.push_back(value_of(tape, named.components[i], named.name + suffix[i]));
  }
  return values;
}

/// The latest number or vector of that name, from the inputs to the step.
std::string number_of(const Tape& tape, const std::string& name, std::ptrdiff_t step, Precision precision) {
  const auto found = std::find_if(tape.names.rbegin(), tape.names.rend(), [&](const NamedValue& named) {
    return named.step <= step && named.name == name;
  });
  if (found == tape.names.rend())
    throw std::logic_error("a step speaks of " + name + ", which has no number");
  std::vector<std::string> numbers;
  for (const OperationId id : found->components) numbers.push_back(shown(tape.at(id).value, precision));
  return numbers.size() == 1 ? numbers[0] : fmt::format("({})", fmt::join(numbers, ", "));
}

/// What the step means, with a number in the place of each {name}.
std::string meaning_of(const Tape& tape, std::ptrdiff_t step, Precision precision) {
  std::string meaning = tape.steps[static_cast<std::size_t>(step)].meaning;
  for (std::size_t open = meaning.find('{'); open != std::string::npos; open = meaning.find('{', open)) {
    const std::size_t close = meaning.find('}', open);
    meaning.replace(open, close + 1 - open,
                    number_of(tape, meaning.substr(open + 1, close - open - 1), step, precision));
  }
  return meaning;
}

/// What decides the verdict: a discriminant, an unnamed difference, or, where the sign is a mere flag,
/// nothing but the comparisons before it.
std::string decider_of(const Tape& tape, OperationId id) {
  const Operation<Shadow>& o = tape.at(id);
  if (o.op == Operator::constant) return "";
  return o.name.empty() ? text_of(formula_of(tape, id)) : "the discriminant";
}

/// What the worst of a step's numbers has lost; where it has none, anything may have been.
double lost_by(const WalkStep& step) {
  double most = step.values.empty() ? infinity<double> : 0;
  for (const WalkValue& value : step.values) most = std::max(most, value.bits_lost);
  return most;
}

/// -1 for no real root (NaN counts so), 0, 1.
template <class T>
int sign_of_discriminant(const T& value) {
  if (value > 0) return 1;
  return value == 0 ? 0 : -1;
}

/// What an answer has lost; an answer that is rightly infinite, since the exact one is too large, nothing.
double lost_by_answer(const Operation<Shadow>& o, Precision precision) {
  const double largest = precision == Precision::float32
                             ? static_cast<double>(std::numeric_limits<float>::max())
                             : std::numeric_limits<double>::max();
  const bool overflows_rightly =
      std::isinf(o.value) && (o.value > 0 ? o.exact > largest : o.exact < -largest);
  return overflows_rightly ? 0 : o.bits_lost;
}

void judge(Walkthrough& walk, const Tape& tape, const Ending& ending) {
  const Operation<Shadow>& D = tape.at(ending.discriminant);
  const int rounded = sign_of_discriminant(D.value);
  const int exact = sign_of_discriminant(D.exact);
  OperationId worst = ending.discriminant;
  if (rounded != exact) {
    walk.outcome = Faithfulness::flipped;
  } else if (exact < 0) {
    return;  // a miss in both: nothing hangs on the digits
  } else {
    const auto lost = [&](OperationId id) { return lost_by_answer(tape.at(id), walk.precision); };
    worst = lost(ending.lo) >= lost(ending.hi) ? ending.lo : ending.hi;
    if (lost(worst) < noteworthy) return;
    walk.outcome = Faithfulness::inaccurate;
  }
  walk.answer_bits_lost = tape.at(worst).bits_lost;
  walk.decisive_loss = find_decisive_loss(tape, worst, noteworthy);
}

}  // namespace

Walkthrough steps_of(const Tape& tape, Precision precision) {
  Walkthrough walk;
  walk.precision = precision;
  walk.digits = precision == Precision::float32 ? std::numeric_limits<float>::digits
                                                : std::numeric_limits<double>::digits;
  for (std::size_t i = 0; i < tape.steps.size(); ++i) {
    walk.steps.push_back({tape.steps[i].title, meaning_of(tape, static_cast<std::ptrdiff_t>(i), precision)});
  }
  for (const NamedValue& named : tape.names) {
    auto& values = named.step < 0 ? walk.inputs : walk.steps.at(static_cast<std::size_t>(named.step)).values;
    const auto more = named_values(tape, named);
    values.insert(values.end(), more.begin(), more.end());
  }
  for (std::size_t i = 0; i < walk.steps.size(); ++i) {
    WalkStep& step = walk.steps[i];
    const auto operations = operations_of_step(tape, static_cast<std::ptrdiff_t>(i));
    step.loss = worst_loss_of(tape, operations, lost_by(step));
    step.caption = loss_sentence(step.loss);
    const double worst = walk.worst_loss ? walk.worst_loss->bits_lost_here : 0;
    if (step.loss && step.loss->bits_lost_here > worst) walk.worst_loss = step.loss;
  }
  return walk;
}

Walkthrough walkthrough_of(const Tape& tape, const Ending& ending, Precision precision) {
  Walkthrough walk = steps_of(tape, precision);
  walk.lo = tape.at(ending.lo).value;
  walk.hi = tape.at(ending.hi).value;
  walk.decider = decider_of(tape, ending.discriminant);
  walk.is_decider_zero = tape.at(ending.discriminant).value == 0;
  judge(walk, tape, ending);
  return walk;
}

}  // namespace rayproof::viz
