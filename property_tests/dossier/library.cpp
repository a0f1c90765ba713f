#include "dossier/library.hpp"

#include <fmt/format.h>

#include <sstream>
#include <stdexcept>

#include "case/json/ordered.hpp"
#include "case/writer.hpp"
#include "subjects/program/child.hpp"

namespace rayproof::dossier {
namespace {

using Clock = std::chrono::steady_clock;
using Json = nlohmann::ordered_json;

/// What a program printed, and how it ended.
struct Printed {
  std::vector<Json> lines{};
  std::string ending{};
};

Printed run(const std::string& command, std::string input, std::chrono::milliseconds patience) {
  program::Child child(command);
  std::string received;
  const auto end = Clock::now() + patience;
  bool is_open = true;
  while (!child.is_output_closed() && Clock::now() < end) {
    if (input.empty() && std::exchange(is_open, false)) child.close_input();
    child.exchange(input, received, std::chrono::milliseconds(50));
  }
  Printed printed;
  printed.ending = child.is_output_closed() ? child.how_it_ended() : "did not return";
  std::istringstream lines(received);
  for (std::string line; std::getline(lines, line);)
    if (Json one = read_json(line, false); one.is_object()) printed.lines.push_back(std::move(one));
  return printed;
}

double number_in(const Json& value) {
  if (value.is_number()) return value.get<double>();
  if (value.is_boolean()) return value.get<bool>() ? 1 : 0;
  const auto text = value.is_string() ? value.get<std::string>() : "nan";
  return text == "inf" ? infinity<double> : text == "-inf" ? -infinity<double> : std::nan("");
}

void append_numbers(const Json& value, std::vector<double>& numbers) {
  if (!value.is_array()) return numbers.push_back(number_in(value));
  for (const Json& one : value) append_numbers(one, numbers);
}

NamedNumbers numbers_of(const Json& object) {
  NamedNumbers named;
  for (const auto& [name, value] : object.items()) append_numbers(value, named[name]);
  return named;
}

}  // namespace

LibraryFacts facts_of(const std::string& command) {
  const Printed said = run(command + " --about", "", std::chrono::seconds(20));
  if (said.lines.empty())
    throw std::runtime_error("the library's program does not say which library it asks");
  const Json& about = said.lines.front();
  LibraryFacts facts{about.at("library"), about.at("version"), about.at("build"), about.at("tracker")};
  for (const Json& one : about.value("documented", Json::array()))
    facts.documented.emplace_back(one.at("fault"), one.at("sentence"));
  return facts;
}

Reproduction reproduction_of(const std::string& command, const Case& one,
                             std::chrono::milliseconds patience) {
  const Printed shown = run(command + " --reproduce", write_case(one) + "\n", patience);
  Reproduction made;
  for (const Json& line : shown.lines) {
    if (line.contains("source")) {
      made.function = line.at("function");
      made.source = line.at("source");
      made.inputs = numbers_of(line.at("inputs"));
    }
    if (line.contains("printed")) {
      made.printed = line.at("printed");
      made.said = numbers_of(line.at("said"));
      made.has_returned = true;
    }
  }
  if (made.source.empty())
    throw std::runtime_error("the library's program did not show in time how it asks this case");
  if (!made.has_returned) made.ending = shown.ending;
  return made;
}

}  // namespace rayproof::dossier
