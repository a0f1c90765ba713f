#include "viz/walkthrough/sentences.hpp"

#include <algorithm>
#include <cctype>

#include "viz/trace/vector_formula.hpp"

namespace rayproof::viz {

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
  bool is_found = false;
  (void)put_in(sentence, [&](const std::string& word) {
    is_found = is_found || word == name || word == name + ".";
    return word;
  });
  const bool is_compound = !is_found && std::any_of(name.begin(), name.end(), [](unsigned char c) {
    return c >= 0x80 || c == '/' || c == ' ' || c == '(';
  });
  return is_found || (is_compound && sentence.find(name) != std::string::npos);
}

std::size_t letters_of(const std::string& text) {
  std::size_t letters = 0;
  for (const unsigned char byte : text) letters += (byte & 0xC0U) != 0x80U && byte != 0xCC ? 1 : 0;
  return letters;
}

}  // namespace rayproof::viz
