#pragma once
/// \file
/// Names that somebody who mistyped one may have meant.

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rayproof {

/// How many letters must be put in, left out or replaced to make one name the other (V. Levenshtein, 1966).
[[nodiscard]] inline std::size_t edit_distance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= from.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= to.size(); ++j) {
      const std::size_t replaced = diagonal + (from[i - 1] == to[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

/// The `count` names nearest to `name`, the nearest first.
[[nodiscard]] inline std::vector<std::string> near_names(std::string_view name,
                                                         std::vector<std::string> names, std::size_t count) {
  std::stable_sort(names.begin(), names.end(), [name](const std::string& a, const std::string& b) {
    return edit_distance(name, a) < edit_distance(name, b);
  });
  names.resize(std::min(count, names.size()));
  return names;
}

namespace detail {

[[nodiscard]] inline std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

/// Whether a name ends like fov_x.
[[nodiscard]] inline bool has_axis(const std::string& name) {
  return name.size() > 2 && name[name.size() - 2] == '_';
}

/// How many letters of `given` are wrong if `known` is meant; nothing where it can't be.
[[nodiscard]] inline std::optional<std::size_t> wrong_letters(const std::string& given,
                                                              const std::string& known) {
  constexpr std::size_t shortest_beginning = 3;
  if (given.size() >= shortest_beginning && known.starts_with(given)) return 0;
  const auto [shorter, longer] = std::minmax({given.size(), known.size()});
  // The lengths decide first: a name as long as a line is never compared letter by letter.
  if (longer == 0 || longer - shorter > longer / 3) return std::nullopt;
  const std::size_t wrong = edit_distance(given, known);
  const bool is_sibling = wrong == 1 && has_axis(given) && has_axis(known) && given.back() != known.back();
  return is_sibling || wrong > longer / 3 ? std::nullopt : std::optional(wrong);
}

}  // namespace detail

/// The one of `names` that a misspelt `name` most likely stands for: a third of its letters wrong at most, or
/// all but its beginning left out ("dir" for "direction"), whatever the case of the letters. Nothing where
/// two are equally near, and never one that differs in its axis alone: fov_x and fov_y are two names.
[[nodiscard]] inline std::optional<std::string> likely_name(std::string_view name,
                                                            const std::vector<std::string>& names) {
  std::optional<std::string> likely;
  std::size_t fewest = std::string_view::npos;
  for (const std::string& known : names) {
    const auto wrong = detail::wrong_letters(detail::lower(name), detail::lower(known));
    if (!wrong || *wrong > fewest) continue;
    likely = *wrong < fewest ? std::optional(known) : std::nullopt;
    fewest = *wrong;
  }
  return likely;
}

/// What a sentence on a name that there is not goes on with: "; did you mean sphere?", or "; there are box,
/// sphere" where none is likely.
[[nodiscard]] inline std::string names_instead(std::string_view name, const std::vector<std::string>& names) {
  if (const auto meant = likely_name(name, names)) return "; did you mean " + *meant + "?";
  std::string all;
  for (const std::string& known : names) all += (all.empty() ? "; there are " : ", ") + known;
  return all;
}

}  // namespace rayproof
