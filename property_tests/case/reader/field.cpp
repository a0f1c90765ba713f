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

[[noreturn]] void refuse_as_number(const Field& field) {
  const json::Node& node = field.node();
  std::string sentence = R"(must be a number, or a string like "0x1.8p+1", "1.5", "inf", "-inf" or "nan")";
  const std::string_view likely =
      node.kind == json::Kind::string ? case_spelling(json::unquote(node.text)) : std::string_view();
  if (!likely.empty()) sentence += "; " + did_you_mean(std::string(likely));
  field.refuse(sentence);
}

}  // namespace

std::string Field::path() const {
  if (parent == nullptr) return "";
  if (position) return fmt::format("{}[{}]", parent->path(), *position);
  const std::string before = parent->path();
  return before.empty() ? std::string(name) : fmt::format("{}.{}", before, name);
}

void Field::refuse(std::string_view what) const {
  const std::string where = path();
  throw Refusal(where, fmt::format("{} {}", where.empty() ? "the case" : where, what));
}

void Field::refuse_unknown(std::string_view what, std::string_view given,
                           const std::vector<std::string>& known) const {
  const std::optional<std::string> likely = likely_name(given, known);
  std::vector<std::string> quoted;
  for (const std::string& one : known) quoted.push_back(json::quote(one));
  refuse(fmt::format("is an unknown {}, {}; {}", what, json::quote(given),
                     likely ? did_you_mean(*likely) : fmt::format("known: {}", fmt::join(quoted, ", "))));
}

std::vector<Field> Field::elements(std::string_view expected, std::optional<std::size_t> size) const {
  if (node().kind != json::Kind::array) refuse(expected);
  std::vector<Field> all;
  for (std::size_t child = index + 1; child < node().end; child = (*document)[child].end) {
    all.push_back({document, child, this, {}, all.size()});
  }
  if (size && all.size() != *size) refuse(expected);
  return all;
}

ObjectReader::ObjectReader(const Field& object) : object_(&object) {
  if (object.node().kind != json::Kind::object) object.refuse("must be a JSON object");
}

std::optional<Field> ObjectReader::find(std::string_view name) {
  known_.push_back(name);
  const json::Document& document = *object_->document;
  std::optional<Field> found;
  for (std::size_t i = object_->index + 1; i < object_->node().end; i = document[i].end) {
    if (json::unquote(document[i].key) == name) found = Field{&document, i, object_, name, {}};
  }
  return found;
}

Field ObjectReader::need(std::string_view name) {
  if (const std::optional<Field> found = find(name)) return *found;
  for (const Unknown& one : unknown()) {
    if (one.likely) refuse(one);
  }
  Field{object_->document, object_->index, object_, name, {}}.refuse("is missing");
}

void ObjectReader::refuse_unknown() const {
  const json::Document& document = *object_->document;
  for (std::size_t i = object_->index + 1; i < object_->node().end; i = document[i].end) {
    if (!is_known(document[i].key)) refuse(unknown().front());
  }
}

bool ObjectReader::is_known(std::string_view key) const {
  return std::ranges::find(known_, json::unquote(key)) != known_.end();
}

bool ObjectReader::has_misspelt(std::string_view name) const {
  const std::vector<Unknown> all = unknown();
  return std::any_of(all.begin(), all.end(), [name](const Unknown& one) { return one.likely == name; });
}

std::vector<ObjectReader::Unknown> ObjectReader::unknown() const {
  const json::Document& document = *object_->document;
  std::vector<std::string> absent(known_.begin(), known_.end());
  std::vector<Unknown> all;
  for (std::size_t i = object_->index + 1; i < object_->node().end; i = document[i].end) {
    if (!is_known(document[i].key)) all.push_back({document[i].key});
    std::erase(absent, json::unquote(document[i].key));
  }
  for (Unknown& one : all) one.likely = likely_name(json::unquote(one.key), absent);
  return all;
}

void ObjectReader::refuse(const Unknown& one) const {
  object_->refuse(fmt::format("has an unknown field {}{}", one.key,
                              one.likely ? "; " + did_you_mean(*one.likely) : std::string()));
}

std::string read_string(const Field& field) {
  if (field.node().kind != json::Kind::string) field.refuse("must be a string");
  return json::unquote(field.node().text);
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
  if (!std::isfinite(value)) {
    field.refuse(precision == Precision::float32 ? "must be finite as a float32"
                                                 : "must be finite as a float64");
  }
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
