#pragma once
/// \file
/// The fields of a report's JSON, each refused by its name where it is no such thing as a report has.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "bench/figures/json.hpp"
#include "case/json/ordered.hpp"

namespace rayproof::report {

/// A member of an object, as what it is to be; FiguresError where it is not there or something else.
template <class Value>
[[nodiscard]] Value member(const nlohmann::ordered_json& json, const std::string& place, const char* name) {
  if (!json.is_object() || !json.contains(name))
    throw FiguresError(fmt::format("{}: there is no \"{}\"", place, name));
  try {
    return json[name].get<Value>();
  } catch (const nlohmann::ordered_json::exception&) {
    throw FiguresError(fmt::format("{}: \"{}\" is something else than it should be", place, name));
  }
}

/// A number from `least` to `most`; `name` has it.
[[nodiscard]] inline double number_from(const nlohmann::ordered_json& value, const std::string& place,
                                        const char* name, double least, double most) {
  if (!value.is_number())
    throw FiguresError(fmt::format("{}: \"{}\" is something else than it should be", place, name));
  const auto number = value.get<double>();
  if (!(number >= least && number <= most))
    throw FiguresError(fmt::format("{}: \"{}\" can't be {:g}", place, name, number));
  return number;
}

/// How many there are of something, from `least`: as a double has each of them.
[[nodiscard]] inline std::size_t count_in(const nlohmann::ordered_json& json, const std::string& place,
                                          const char* name, double least = 0) {
  const auto value = member<nlohmann::ordered_json>(json, place, name);
  return static_cast<std::size_t>(std::ceil(number_from(value, place, name, least, 1e15)));
}

/// NaN where there is none. Only a mean of bits has an end: no two numbers have more floats between them.
[[nodiscard]] inline double error_in(const nlohmann::ordered_json& json, const std::string& place,
                                     const char* name) {
  const auto value = member<nlohmann::ordered_json>(json, place, name);
  const bool is_mean = name == std::string_view("mean_bits");
  if (value.is_null()) return std::numeric_limits<double>::quiet_NaN();
  if (value == "inf" && !is_mean) return std::numeric_limits<double>::infinity();
  return number_from(value, place, name, 0, is_mean ? 64 : std::numeric_limits<double>::max());
}

/// Times for a ray: nothing has no logarithm to be drawn, and none takes a year.
inline constexpr double least_ns = 1e-6, most_ns = 3e16;

[[nodiscard]] inline double time_in(const nlohmann::ordered_json& json, const std::string& place,
                                    const char* name) {
  return number_from(member<nlohmann::ordered_json>(json, place, name), place, name, least_ns, most_ns);
}

[[nodiscard]] inline std::vector<double> times_in(const nlohmann::ordered_json& json,
                                                  const std::string& place, const char* name) {
  const auto all = member<nlohmann::ordered_json>(json, place, name);
  if (!all.is_array()) throw FiguresError(fmt::format("{}: \"{}\" is no array", place, name));
  std::vector<double> times;
  for (const auto& one : all) times.push_back(number_from(one, place, name, least_ns, most_ns));
  return times;
}

/// The one of some values that has this name.
template <class Value>
[[nodiscard]] Value named_in(const nlohmann::ordered_json& json, const std::string& place, const char* name,
                             std::initializer_list<Value> values) {
  const auto wanted = member<std::string>(json, place, name);
  const auto found = std::ranges::find_if(values, [&](Value value) { return name_of(value) == wanted; });
  if (found == values.end()) throw FiguresError(fmt::format("{}: \"{}\" can't be '{}'", place, name, wanted));
  return *found;
}

}  // namespace rayproof::report
