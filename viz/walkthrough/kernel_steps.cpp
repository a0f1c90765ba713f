#include "viz/walkthrough/lesson.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <rayproof/formulas/finite.hpp>

#include "viz/explain/case_report.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/trace/record.hpp"
#include "viz/walkthrough/stage_values.hpp"

namespace rayproof::viz {
namespace {

/// Gives the value its formula, a vector one for all its components, and the numbers in it.
void put_numbers_in(StageValue& value, Precision precision) {
  std::vector<Formula> formulas;
  for (const WalkValue& component : value.components) formulas.push_back(component.formula);
  value.formula = formulas.size() == 1 ? formulas[0] : vector_formula(formulas);
  value.put_in = with_numbers(value.formula, precision);
}

/// Whether it has a formula that says more than its name.
bool has_formula(const StageValue& value) {
  return value.formula != nullptr && text_of(value.formula) != value.name;
}

/// More letters than this a slide has no room for below its picture.
constexpr std::size_t most_letters = 310;

/// The equations of a step that has room for this many letters: of the last value, which the step is for, and
/// of as many before it as there is room for, without the numbers put in where that helps. The value panel
/// has them all.
std::string equations_of(const std::vector<StageValue>& values, Precision precision, std::size_t room) {
  std::vector<const StageValue*> shown_values;
  for (const StageValue& value : values)
    if (has_formula(value)) shown_values.push_back(&value);
  if (shown_values.empty()) {
    for (const StageValue& value : values) shown_values.push_back(&value);
  }
  if (shown_values.empty()) return {};
  StageValue last = *shown_values.back();
  shown_values.pop_back();
  if (letters_of(equation_of(last, precision)) > room) last.put_in.reset();
  if (letters_of(equation_of(last, precision)) > room) last.formula.reset();
  std::string text = equation_of(last, precision);
  for (; !shown_values.empty(); shown_values.pop_back()) {
    StageValue value = *shown_values.back();
    std::string longer = equation_of(value, precision) + "; " + text;
    if (letters_of(longer) > room) {
      value.put_in.reset();
      longer = equation_of(value, precision) + "; " + text;
    }
    if (letters_of(longer) > room) break;
    text = longer;
  }
  return text;
}

/// What hangs on a name, in the world; without items that overflowed, or that shrank to a point.
Items items_of(const std::string& name, const NumbersByName& n, const Setting& setting) {
  Items items;
  for (const Binding& binding : setting.bindings) {
    if (binding.name == name) append(items, binding.draw(n));
  }
  std::erase_if(items, [&](StageItem& item) {
    for (glm::dvec3& p : item.points) p = setting.to_world(p);
    const bool is_placed = std::ranges::all_of(item.points, [](const glm::dvec3& p) { return is_finite(p); });
    return !is_placed ||
           (item.form != Form::point && item.points.size() == 2 && item.points[0] == item.points[1]);
  });
  return items;
}

bool begins_anew(const std::string& name, const Setting& setting) {
  return std::ranges::any_of(
      setting.bindings, [&](const Binding& binding) { return binding.begins_anew && binding.name == name; });
}

/// The wide view for a step that shows something far from the shape.
StageView view_of(const StageStep& step, const Setting& setting) {
  if (setting.starts_far()) return setting.near;
  for (const StageItem& item : step.items) {
    for (const glm::dvec3& p : item.points) {
      if (glm::length(p - setting.near.centre) > 1.6 * view_aspect * setting.near.radius) return setting.wide;
    }
  }
  return setting.near;
}

/// The values of a step in runs that each begin with what leads to one that is drawn: a new thing a part.
/// Where nothing of the step can be drawn (there are no roots), all in one.
std::vector<std::vector<StageValue>> parts_of(const std::vector<StageValue>& values, const NumbersByName& n,
                                              const Setting& setting) {
  std::vector<std::vector<StageValue>> parts{{}};
  bool is_drawn = false;
  for (const StageValue& value : values) {
    const bool draws = !items_of(value.name, n, setting).empty();
    if (is_drawn && draws) parts.emplace_back();
    is_drawn = is_drawn || draws;
    parts.back().push_back(value);
  }
  return parts;
}

/// A step's sentences, each with the part that gives the number that it begins with, or else the last number
/// that it speaks of.
std::vector<std::string> words_of(const std::string& meaning,
                                  const std::vector<std::vector<StageValue>>& parts) {
  std::vector<std::string> words(parts.size());
  std::size_t part = 0;
  for (const std::string& sentence : sentences_of(meaning)) {
    bool has_subject = false;
    for (std::size_t i = part; i < parts.size() && !has_subject; ++i) {
      for (const StageValue& value : parts[i]) {
        has_subject = has_subject || sentence.starts_with(value.name + " ");
        if (has_subject || mentions(sentence, value.name)) part = i;
      }
    }
    words[part] += (words[part].empty() ? "" : " ") + sentence;
  }
  return words;
}

void caption(StageStep& step, const CaseReport& report, bool is_last) {
  const std::size_t words = std::min(most_letters, letters_of(step.words));
  const std::string numbers = !step.values.empty()
                                  ? equations_of(step.values, report.one.precision, most_letters - words)
                              : is_last ? fmt::format("So the verdict is: {}.", answer_in_words(report))
                                        : "";
  const bool is_both = !step.words.empty() && !numbers.empty();
  step.caption = step.words + (is_both ? " " : "") + numbers;
  if (step.caption.empty()) step.caption = step.title + ".";
}

/// What became of the digits; nothing to say where all are well.
std::string digits_of(const std::vector<StageValue>& values, const std::optional<PrecisionLoss>& loss) {
  const bool is_spoilt = std::ranges::any_of(values, [](const StageValue& value) {
    return std::ranges::any_of(value.components,
                               [](const WalkValue& component) { return component.bits_lost >= noteworthy; });
  });
  return !loss && is_spoilt ? "Digits were lost in earlier steps, or in several small roundings."
                            : loss_sentence(loss);
}

}  // namespace

std::vector<StageStep> kernel_steps(const CaseReport& report, const Walkthrough& walk, std::size_t index,
                                    const Setting& setting, bool is_split) {
  const NumbersByName n(walk, index);
  const std::string& title = walk.steps[index].title;
  const Precision precision = report.one.precision;
  std::vector<StageValue> values = grouped(walk.steps[index].values);
  for (StageValue& value : values) put_numbers_in(value, precision);
  const auto parts = is_split ? parts_of(values, n, setting) : std::vector<std::vector<StageValue>>{values};
  const std::vector<std::string> words = words_of(walk.steps[index].meaning, parts);
  std::vector<StageStep> steps;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    StageStep step;
    step.title =
        parts.size() == 1 ? title : fmt::format("{} ({}\u00a0of\u00a0{})", title, i + 1, parts.size());
    step.values = parts[i];
    step.words = words[i];
    if (i == 0) append(step.items, items_of(title, n, setting));
    for (const StageValue& value : step.values) {
      append(step.items, items_of(value.name, n, setting));
      step.begins_anew = step.begins_anew || begins_anew(value.name, setting);
    }
    step.digits =
        digits_of(step.values, parts.size() == 1 ? walk.steps[index].loss : worst_loss_of(parts[i]));
    caption(step, report, index + 1 == walk.steps.size());
    step.view = view_of(step, setting);
    steps.push_back(std::move(step));
  }
  return steps;
}

}  // namespace rayproof::viz
