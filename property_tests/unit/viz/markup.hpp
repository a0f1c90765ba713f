#pragma once
/// \file
/// Just enough of XML to catch a picture that a browser would refuse.

#include <regex>
#include <string>
#include <vector>

namespace rayproof::viz {

/// What is wrong with the nesting of tags or with an attribute's quotes; empty where nothing is.
[[nodiscard]] inline std::string complaint_about_xml(const std::string& text) {
  static const std::regex opening("^([a-zA-Z][\\w-]*)((?:\\s+[\\w:-]+=\"[^\"<]*\")*)\\s*(/?)$");
  std::vector<std::string> open;
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at)) {
    const std::size_t end = text.find('>', at);
    if (end == std::string::npos) return "a tag that does not end";
    const std::string tag = text.substr(at + 1, end - at - 1);
    at = end;
    if (tag.starts_with("/")) {
      if (open.empty() || open.back() != tag.substr(1)) return "</" + tag.substr(1) + "> closes nothing";
      open.pop_back();
      continue;
    }
    std::smatch parts;
    if (!std::regex_match(tag, parts, opening)) return "not a tag: " + tag;
    if (parts[3].length() == 0) open.push_back(parts[1]);
  }
  return open.empty() ? "" : open.back() + " is never closed";
}

/// The first address of another place; the name of SVG's own vocabulary is none.
[[nodiscard]] inline std::string complaint_about_addresses(std::string text) {
  const std::string own = "http://www.w3.org/2000/svg";
  for (std::size_t at = text.find(own); at != std::string::npos; at = text.find(own))
    text.erase(at, own.size());
  for (const char* const sign : {"http:", "https:", "//", "url(", "@import", "src=", "href="}) {
    const std::size_t at = text.find(sign);
    if (at != std::string::npos) return text.substr(at, 40);
  }
  return "";
}

}  // namespace rayproof::viz
