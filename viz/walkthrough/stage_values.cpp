#include "viz/walkthrough/stage_values.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "viz/trace/expression.hpp"
#include "viz/trace/numbers.hpp"

namespace rayproof::viz {
namespace {

/// The texts of a value's components; a vector's in parentheses.
template <class Text>
std::string joined(const StageValue& value, Text as_text) {
  std::string text;
  for (const WalkValue& component : value.components) {
    text += (text.empty() ? "" : ", ") + as_text(component);
  }
  return value.components.size() > 1 ? "(" + text + ")" : text;
}

/// What each was computed from, and the number.
std::vector<std::pair<std::string, double>> components_of(const StageValue& value) {
  std::vector<std::pair<std::string, double>> components;
  for (const WalkValue& component : value.components)
    components.emplace_back(text_of(component.formula), component.value);
  return components;
}

bool is_part_of_name(const std::string& text, std::size_t i) {
  static constexpr std::array<std::string_view, 7> operator_signs{"·", "×", "−", "√", "⁺", "∞", "→"};
  const auto byte = static_cast<unsigned char>(text[i]);
  if (byte < 0x80) return (std::isalnum(byte) != 0) || text[i] == '_' || text[i] == '.';
  return std::ranges::none_of(operator_signs, [&](std::string_view sign) {
    for (std::size_t back = 0; back < sign.size() && back <= i; ++back) {
      if (text.compare(i - back, sign.size(), sign) == 0) return true;
    }
    return false;
  });
}

/// The words and names of a sentence, parted by spaces and operators.
std::vector<std::string> split_words(const std::string& sentence) {
  std::vector<std::string> words{""};
  for (std::size_t i = 0; i < sentence.size(); ++i) {
    if (is_part_of_name(sentence, i)) {
      words.back() += sentence[i];
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  return words;
}

}  // namespace

std::string formula_beside_name(const StageValue& value) {
  const auto bare = [](std::string text) {
    std::erase(text, ' ');
    for (std::size_t at = text.find("−"); at != std::string::npos; at = text.find("−", at))
      text.replace(at, 3, "-");
    return text;
  };
  const std::string formula = text_of(value.formula);
  return bare(formula) == bare(value.name) ? "" : formula;
}

std::vector<StageValue> grouped(const std::vector<WalkValue>& values) {
  std::vector<StageValue> groups;
  for (const WalkValue& value : values) {
    const bool continues = !groups.empty() && (vector_of(value.name, 'y') == groups.back().name ||
                                               vector_of(value.name, 'z') == groups.back().name);
    if (continues) {
      groups.back().components.push_back(value);
      continue;
    }
    StageValue group;
    const std::string vector = vector_of(value.name, 'x');
    group.name = vector.empty() ? value.name : vector;
    group.components = {value};
    groups.push_back(std::move(group));
  }
  // A kernel may compute, and name, the same twice.
  std::vector<StageValue> different;
  for (StageValue& group : groups) {
    const auto is_same = [&](const StageValue& other) {
      return other.name == group.name && components_of(other) == components_of(group);
    };
    if (std::ranges::none_of(different, is_same)) different.push_back(std::move(group));
  }
  return different;
}

std::string shown(const StageValue& value, Precision precision) {
  return joined(value, [&](const WalkValue& component) { return shown(component.value, precision); });
}

std::string exact_of(const StageValue& value) {
  return joined(value, [](const WalkValue& component) { return component.exact; });
}

const WalkValue& worst_component(const StageValue& value) {
  return *std::ranges::max_element(
      value.components, [](const WalkValue& a, const WalkValue& b) { return a.bits_lost < b.bits_lost; });
}

std::optional<PrecisionLoss> worst_loss_of(const std::vector<StageValue>& values) {
  std::optional<PrecisionLoss> worst;
  for (const StageValue& value : values) {
    for (const WalkValue& component : value.components) {
      const auto& loss = component.loss;
      if (loss && (!worst || loss->bits_lost_here > worst->bits_lost_here)) worst = loss;
    }
  }
  return worst;
}

std::string equation_of(const StageValue& value, Precision precision) {
  std::string text = value.name;
  if (const std::string formula = formula_beside_name(value); !formula.empty()) text += " = " + formula;
  const std::string result = shown(value, precision), numbers = text_of(value.put_in);
  if (!numbers.empty() && numbers != result && numbers != text_of(value.formula)) text += " = " + numbers;
  return text + " = " + result;
}

std::vector<std::string> sentences_of(const std::string& text) {
  std::vector<std::string> sentences;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(". ", begin), text.size() - 1) + 1;
    sentences.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return sentences;
}

bool mentions(const std::string& sentence, const std::string& name) {
  if (name == "a") return false;
  const std::vector<std::string> words = split_words(sentence);
  const auto is_name = [&](const std::string& word) { return word == name || word == name + "."; };
  if (std::ranges::any_of(words, is_name)) return true;
  const bool is_compound = std::ranges::any_of(
      name, [](unsigned char c) { return c >= 0x80 || c == '/' || c == ' ' || c == '('; });
  return is_compound && sentence.find(name) != std::string::npos;
}

std::size_t letters_of(const std::string& text) {
  std::size_t letters = 0;
  for (const unsigned char byte : text) letters += (byte & 0xC0U) != 0x80U && byte != 0xCC ? 1 : 0;
  return letters;
}

}  // namespace rayproof::viz
