#include "viz/walkthrough/sentences.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace rayproof::viz {
namespace {

bool is_part_of_name(const std::string& text, std::size_t i) {
  static constexpr std::array<std::string_view, 7> operator_signs{"·", "×", "−", "√", "⁺", "∞", "→"};
  const auto byte = static_cast<unsigned char>(text[i]);
  if (byte < 0x80) return (std::isalnum(byte) != 0) || text[i] == '_' || text[i] == '.';
  return std::none_of(operator_signs.begin(), operator_signs.end(), [&](std::string_view sign) {
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
  if (std::any_of(words.begin(), words.end(), is_name)) return true;
  const bool is_compound = std::any_of(name.begin(), name.end(), [](unsigned char c) {
    return c >= 0x80 || c == '/' || c == ' ' || c == '(';
  });
  return is_compound && sentence.find(name) != std::string::npos;
}

std::size_t letters_of(const std::string& text) {
  std::size_t letters = 0;
  for (const unsigned char byte : text) letters += (byte & 0xC0U) != 0x80U && byte != 0xCC ? 1 : 0;
  return letters;
}

}  // namespace rayproof::viz
