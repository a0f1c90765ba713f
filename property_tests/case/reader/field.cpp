#include "case/reader/field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/json/number_text.hpp"
#include "case/reader/near_names.hpp"
#include "case/shape_format.hpp"

namespace rayproof {
namespace {

std::string did_you_mean(const std::string& name) {
  return fmt::format("did you mean {}?", json::quote(name));
}

[[noreturn]] void refuse_at(const std::string& path, std::string_view what) {
  throw Refusal(path, fmt::format("{} {}", path.empty() ? "the case" : path, what));
}

[[noreturn]] void refuse_as_number(const Field& field) {
  const json::Node& node = field.node();
  std::string sentence = R"(must be a number, or a string like "0x1.8p+1", "1.5", "inf", "-inf" or "nan")";
  const std::string_view likely =
      node.kind == json::Kind::string ? case_spelling(json::unquote(node.text)) : std::string_view();
  if (!likely.empty()) sentence += "; " + did_you_mean(std::string(likely));
  field.refuse(sentence);
}

}  // namespace

void Field::refuse(std::string_view what) const { refuse_at(path(), what); }

std::vector<Field> Field::elements(std::string_view expected, std::optional<std::size_t> size) const {
  if (node().kind != json::Kind::array) refuse(expected);
  std::vector<Field> all;
  for (std::size_t child = index + 1; child < node().end; child = (*document)[child].end) {
    all.push_back({document, child});
  }
  if (size && all.size() != *size) refuse(expected);
  return all;
}

ObjectReader::ObjectReader(const Field& object) : object_(object) {
  if (object.node().kind != json::Kind::object) object.refuse("must be a JSON object");
  const json::Document& document = *object.document;
  members_.reserve(8);
  for (std::size_t i = object.index + 1; i < object.node().end; i = document[i].end)
    members_.push_back({json::unquote(document[i].key), {&document, i}});
}

std::optional<Field> ObjectReader::find(std::string_view name) {
  std::optional<Field> found;
  for (Member& member : members_) {
    if (member.name != name) continue;
    member.is_known = true;
    found = member.field;
  }
  if (!found) absent_.emplace_back(name);
  return found;
}

Field ObjectReader::need(std::string_view name) {
  if (const std::optional<Field> found = find(name)) return *found;
  for (const Member& member : members_)
    if (likely(member)) refuse(member);
  std::string path = object_.path();
  json::append_member(path, name);
  refuse_at(path, "is missing");
}

void ObjectReader::refuse_unknown() const {
  for (const Member& member : members_)
    if (!member.is_known) refuse(member);
}

bool ObjectReader::has_misspelt(std::string_view name) const {
  return std::ranges::any_of(members_, [&](const Member& member) { return likely(member) == name; });
}

std::optional<std::string> ObjectReader::likely(const Member& member) const {
  return member.is_known ? std::nullopt : likely_name(member.name, absent_);
}

void ObjectReader::refuse(const Member& unknown) const {
  const auto meant = likely(unknown);
  object_.refuse(fmt::format("has an unknown field {}{}", unknown.field.node().key,
                             meant ? "; " + did_you_mean(*meant) : std::string()));
}

std::string read_string(const Field& field) {
  if (field.node().kind != json::Kind::string) field.refuse("must be a string");
  return json::unquote(field.node().text);
}

std::size_t read_name(const Field& field, std::string_view what, const std::vector<std::string>& known) {
  const std::string given = read_string(field);
  const auto place = std::ranges::find(known, given);
  if (place != known.end()) return static_cast<std::size_t>(place - known.begin());
  const std::optional<std::string> likely = likely_name(given, known);
  std::vector<std::string> quoted;
  for (const std::string& one : known) quoted.push_back(json::quote(one));
  field.refuse(
      fmt::format("is an unknown {}, {}; {}", what, json::quote(given),
                  likely ? did_you_mean(*likely) : fmt::format("known: {}", fmt::join(quoted, ", "))));
}

double read_number(const Field& field, Precision precision) {
  const json::Node& node = field.node();
  std::optional<double> number;
  if (node.kind == json::Kind::number) number = parse_number(node.text);
  if (node.kind == json::Kind::string) number = parse_number(json::unquote(node.text));
  if (!number) refuse_as_number(field);
  return round_to(precision, *number);
}

void read_value(const Field& field, Precision precision, double& value) {
  value = read_number(field, precision);
  if (!std::isfinite(value)) field.refuse(fmt::format("must be finite as a {}", name_of(precision)));
}

void read_value(const Field& field, Precision precision, glm::dvec3& value) {
  const std::vector<Field> elements = field.elements("must be an array of 3 numbers", 3);
  for (glm::length_t i = 0; i < 3; ++i)
    read_value(elements[static_cast<std::size_t>(i)], precision, value[i]);
}

void read_value(const Field& field, Precision precision, Vec2<double>& value) {
  const std::vector<Field> elements = field.elements("must be an array of 2 numbers", 2);
  read_value(elements[0], precision, value.x);
  read_value(elements[1], precision, value.y);
}

void read_value(const Field& field, Precision /*precision*/, bool& value) {
  if (field.node().kind != json::Kind::boolean) field.refuse("must be true or false");
  value = field.node().text == "true";
}

}  // namespace rayproof
