#pragma once
/// \file
/// Just enough of XML to catch a picture that a browser would refuse.

#include <algorithm>
#include <cctype>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rayproof::viz {

/// A tag's name; nothing where its attributes are not name="value" one after another. By hand: std::regex
/// recurses for each letter of a value, and a path has thousands.
[[nodiscard]] inline std::optional<std::string> name_of_tag(std::string_view tag) {
  const auto is_name = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' || c == ':';
  };
  const auto take_name = [&] {
    const auto end = std::find_if_not(tag.begin(), tag.end(), is_name);
    const std::string name(tag.begin(), end);
    tag.remove_prefix(name.size());
    return name;
  };
  if (tag.ends_with('/')) tag.remove_suffix(1);
  const std::string name = take_name();
  while (!tag.empty()) {
    const std::size_t spaces = std::min(tag.find_first_not_of(" \n"), tag.size());
    tag.remove_prefix(spaces);
    if (tag.empty()) break;
    if (spaces == 0 || take_name().empty() || !tag.starts_with("=\"")) return std::nullopt;
    const std::size_t end = tag.find('"', 2);
    if (end == std::string_view::npos || tag.substr(0, end).find('<') != std::string_view::npos)
      return std::nullopt;
    tag.remove_prefix(end + 1);
  }
  return name.empty() ? std::nullopt : std::optional(name);
}

/// What is wrong with the nesting of tags or with an attribute's quotes; empty where nothing is.
[[nodiscard]] inline std::string complaint_about_xml(const std::string& text) {
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
    const auto name = name_of_tag(tag);
    if (!name) return "not a tag: " + tag;
    if (!tag.ends_with('/')) open.push_back(*name);
  }
  return open.empty() ? "" : open.back() + " is never closed";
}

/// The first attribute's value in which a word begins with "inf".
[[nodiscard]] inline std::string complaint_about_numbers(const std::string& text) {
  for (std::size_t at = text.find("=\""); at != std::string::npos; at = text.find("=\"", at)) {
    at += 2;
    const std::string value = text.substr(at, text.find('"', at) - at);
    for (std::size_t i = value.find("inf"); i != std::string::npos; i = value.find("inf", i + 1)) {
      if (i == 0 || std::isalnum(static_cast<unsigned char>(value[i - 1])) == 0) return value;
    }
    at += value.size();
  }
  return "";
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
