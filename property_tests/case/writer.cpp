#include "case/writer.hpp"

#include <glm/matrix.hpp>

#include "case/json/writer.hpp"

namespace rayproof {
namespace {

/// The name of the shape's format as `kind`, then its fields.
template <class S>
void write_fields(JsonWriter& json, const char* kind, const S& shape, Precision precision) {
  json.member(kind).string(ShapeFormat<S>::type);
  ShapeFormat<S>::fields(
      shape, [&](const char* name, const auto& field) { json.member(name).value(field, precision); });
}

template <class Query>
void write(JsonWriter& json, const Query& question, Precision precision) {
  write_fields(json, "query", question, precision);
}

void write(JsonWriter& json, const RayQuestion& question, Precision precision) {
  json.member("ray").open('{');
  json.member("origin").value(question.ray.origin, precision);
  json.member("direction").value(question.ray.direction, precision);
  json.member("t_min").value(question.ray.t_min, precision);
  json.member("t_max").value(question.ray.t_max, precision);
  json.close('}');
  json.member("shape").open('{');
  std::visit([&](const auto& shape) { write_fields(json, "type", shape, precision); }, question.shape);
  json.close('}');
  // Written by rows, held by columns.
  if (question.transform) json.member("transform").value(glm::transpose(*question.transform), precision);
}

/// A list of numbers, each beside its hex form: {"t": 4, "t_hex": "0x1p+2"}.
template <class Numbers>
void write_numbers(JsonWriter& json, const char* name, const char* hex_name, const Numbers& numbers) {
  json.open('[');
  for (const double x : numbers) {
    json.element().open('{');
    json.member(name).value(x);
    json.member(hex_name).hex(x);
    json.close('}');
  }
  json.close(']');
}

void write(JsonWriter& json, const RayAnswer& answer) {
  json.member("verdict").string(answer.hits.count > 0 ? "hit" : "miss");
  if (answer.says_contact) json.member("contact").string(name_of(answer.contact));
  if (!answer.verdict_only) write_numbers(json.member("hits"), "t", "t_hex", answer.hits.view());
  if (answer.point) json.member("point").value(*answer.point);
  if (answer.normal) json.member("normal").value(*answer.normal);
  if (answer.barycentric) json.member("barycentric").value(*answer.barycentric);
}

void write(JsonWriter& json, Position position) { json.member("position").string(name_of(position)); }

void write(JsonWriter& json, const QuadraticAnswer<double>& answer) {
  json.member("kind").string(name_of(answer.kind));
  write_numbers(json.member("roots"), "x", "x_hex", std::span(answer.roots).first(answer.count));
}

}  // namespace

static std::string write_case(const Case& one, Precision digits) {
  JsonWriter json;
  if (!one.id.empty()) json.member("id").raw(one.id);
  json.member("precision").string(name_of(one.precision));
  std::visit([&](const auto& question) { write(json, question, digits); }, one.question);
  if (!one.note.empty()) json.member("note").string(one.note);
  return json.take();
}

std::string write_case(const Case& one) { return write_case(one, one.precision); }

std::string write_case_for_doubles(const Case& one) { return write_case(one, Precision::float64); }

std::string write_answer(const Case& one, const Answer& answer) {
  JsonWriter json;
  if (!one.id.empty()) json.member("id").raw(one.id);
  std::visit([&](const auto& given) { write(json, given); }, answer);
  return json.take();
}

std::string write_refusal(const RefusedCase& refused, std::size_t line) {
  JsonWriter json;
  json.member("id").raw(refused.id().empty() ? "null" : refused.id());
  json.member("line").raw(std::to_string(line));
  json.member("error").string(refused.what());
  return json.take();
}

}  // namespace rayproof
