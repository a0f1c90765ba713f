#include "case/writer.hpp"

#include "case/json/writer.hpp"

namespace rayproof {
namespace {

void write(JsonWriter& json, const RayQuestion& question, Precision precision) {
  const auto number = [&](const char* name, const auto& value) { json.member(name).input(value, precision); };

  json.member("ray").open('{');
  number("origin", question.ray.origin);
  number("direction", question.ray.direction);
  number("t_min", question.ray.t_min);
  number("t_max", question.ray.t_max);
  json.close('}');

  json.member("shape").open('{');
  std::visit(
      [&](const auto& shape) {
        using Format = ShapeFormat<std::decay_t<decltype(shape)>>;
        json.member("type").string(Format::type);
        Format::fields(shape, number);
      },
      question.shape);
  json.close('}');

  if (!question.transform) return;
  std::array<std::array<double, 4>, 4> rows{};
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      rows[row][column] =
          (*question.transform)[static_cast<glm::length_t>(column)][static_cast<glm::length_t>(row)];
    }
  }
  number("transform", rows);
}

void write(JsonWriter& json, const Quadratic<double>& equation, Precision precision) {
  json.member("query").string("quadratic");
  json.member("a").input(equation.a, precision);
  json.member("b").input(equation.b, precision);
  json.member("c").input(equation.c, precision);
}

void write(JsonWriter& json, const PointAndPolygon<double>& question, Precision precision) {
  json.member("query").string("point_in_polygon");
  json.member("point").input(question.point, precision);
  json.member("vertices").input(question.vertices, precision);
}

/// A list of numbers, each beside its hex form: {"t": 4, "t_hex": "0x1p+2"}.
template <class Numbers>
void write_numbers(JsonWriter& json, const char* name, const char* hex_name, const Numbers& numbers) {
  json.open('[');
  for (const double x : numbers) {
    json.element().open('{');
    json.member(name).number(x);
    json.member(hex_name).hex(x);
    json.close('}');
  }
  json.close(']');
}

void write(JsonWriter& json, const RayAnswer& answer) {
  json.member("verdict").string(answer.hits.count > 0 ? "hit" : "miss");
  json.member("contact").string(name_of(answer.contact));
  write_numbers(json.member("hits"), "t", "t_hex", answer.hits.view());
  if (answer.point) json.member("point").number(*answer.point);
  if (answer.normal) json.member("normal").number(*answer.normal);
  if (answer.barycentric) json.member("barycentric").number(*answer.barycentric);
}

void write(JsonWriter& json, Position position) { json.member("position").string(name_of(position)); }

void write(JsonWriter& json, const QuadraticAnswer<double>& answer) {
  json.member("kind").string(name_of(answer.kind));
  write_numbers(json.member("roots"), "x", "x_hex", std::span(answer.roots).first(answer.count));
}

}  // namespace

std::string write_case(const Case& one) {
  JsonWriter json;
  json.open('{');
  if (!one.id.empty()) json.member("id").raw(one.id);
  json.member("precision").string(name_of(one.precision));
  std::visit([&](const auto& question) { write(json, question, one.precision); }, one.question);
  if (!one.note.empty()) json.member("note").string(one.note);
  json.close('}');
  return json.take();
}

std::string write_answer(const Case& one, const Answer& answer) {
  JsonWriter json;
  json.open('{');
  if (!one.id.empty()) json.member("id").raw(one.id);
  std::visit([&](const auto& given) { write(json, given); }, answer);
  json.close('}');
  return json.take();
}

std::string write_refusal(const RefusedCase& refused, std::size_t line) {
  JsonWriter json;
  json.open('{');
  json.member("id").raw(refused.id().empty() ? "null" : refused.id());
  json.member("line").raw(std::to_string(line));
  json.member("error").string(refused.what());
  json.close('}');
  return json.take();
}

}  // namespace rayproof
