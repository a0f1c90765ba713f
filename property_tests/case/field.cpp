#include "case/field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/number_text.hpp"
#include "case/shape_format.hpp"

namespace rayproof {
namespace {

/// Whether a name in quotes is `name`.
bool names(std::string_view quoted, std::string_view name) {
  if (quoted.find('\\') != std::string_view::npos) return json::unquote(quoted) == name;
  return quoted.substr(1, quoted.size() - 2) == name;
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
    if (names(document[i].key, name)) found = Field{&document, i, object_, name, {}};
  }
  return found;
}

Field ObjectReader::need(std::string_view name) {
  if (const std::optional<Field> found = find(name)) return *found;
  Field{object_->document, object_->index, object_, name, {}}.refuse("is missing");
}

void ObjectReader::refuse_unknown() const {
  const json::Document& document = *object_->document;
  for (std::size_t i = object_->index + 1; i < object_->node().end; i = document[i].end) {
    const std::string_view key = document[i].key;
    const auto is_key = [key](std::string_view name) { return names(key, name); };
    if (std::any_of(known_.begin(), known_.end(), is_key)) continue;
    object_->refuse(fmt::format("has an unknown field {}", key));
  }
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
  if (!number)
    field.refuse(R"(must be a number, or a string like "0x1.8p+1", "1.5", "inf", "-inf" or "nan")");
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
