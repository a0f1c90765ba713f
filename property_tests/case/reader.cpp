#include "case/reader.hpp"

#include <cmath>
#include <limits>

#include "case/independent.hpp"
#include "case/reader/field.hpp"
#include "case/reader/shape_reader.hpp"

namespace rayproof {
namespace {

/// One end of the ray's interval: finite, or the one infinity that leaves it open.
double read_end(ObjectReader& reader, const char* name, Precision precision, double otherwise, double open) {
  const auto field = reader.find(name);
  if (!field) return otherwise;
  const double end = read_number(*field, precision);
  if (!std::isfinite(end) && end != open) {
    field->refuse(open > 0 ? "must be finite or inf" : "must be finite or -inf");
  }
  return end;
}

Ray<double> read_ray(const Field& object, Precision precision) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  ObjectReader reader(object);
  Ray<double> ray{};
  read_value(reader.need("origin"), precision, ray.origin);
  const Field direction = reader.need("direction");
  read_value(direction, precision, ray.direction);
  ray.t_min = read_end(reader, "t_min", precision, 0, -inf);
  ray.t_max = read_end(reader, "t_max", precision, inf, inf);
  reader.refuse_unknown();

  if (ray.direction == glm::dvec3(0)) direction.refuse("must not be zero");
  if (ray.t_min > ray.t_max) throw Refusal("ray.t_min", "ray.t_min must not be greater than ray.t_max");
  return ray;
}

RayQuestion read_ray_question(ObjectReader& reader, Precision precision) {
  RayQuestion question{read_ray(reader.need("ray"), precision), {}, {}};
  read_shape(reader.need("shape"), precision, question.shape);
  if (const auto field = reader.find("transform")) question.transform = read_transform(*field, precision);
  return question;
}

template <class Query>
Query read_query(ObjectReader& reader, Precision precision) {
  auto question = read_fields<Query>(reader, precision);
  ShapeFormat<Query>::validate(question);
  return question;
}

Question read_question(ObjectReader& reader, Precision precision) {
  const auto query = reader.find("query");
  if (!query) return read_ray_question(reader, precision);
  if (read_name(*query, "query", {"quadratic", "point_in_polygon"}) == 0)
    return read_query<Quadratic<double>>(reader, precision);
  return read_query<PointAndPolygon<double>>(reader, precision);
}

}  // namespace

Precision read_precision(ObjectReader& reader) {
  const auto field = reader.find("precision");
  if (!field) return Precision::float64;
  return static_cast<Precision>(read_name(*field, "precision", {"float32", "float64"}));
}

glm::dmat4 read_transform(const Field& field, Precision precision) {
  constexpr glm::dvec4 last_row{0, 0, 0, 1};
  glm::dmat4 transform{};
  const std::vector<Field> rows = field.elements("must be an array of 4 rows of 4 numbers", 4);
  for (glm::length_t row = 0; row < 4; ++row) {
    const std::vector<Field> row_elements =
        rows[static_cast<std::size_t>(row)].elements("must be an array of 4 numbers", 4);
    for (glm::length_t column = 0; column < 4; ++column) {
      read_value(row_elements[static_cast<std::size_t>(column)], precision, transform[column][row]);
    }
  }
  for (glm::length_t column = 0; column < 4; ++column) {
    if (transform[column][3] != last_row[column]) field.refuse("must be affine, with the last row 0 0 0 1");
  }
  if (!is_regular(transform)) field.refuse("must not be singular");
  return transform;
}

Case read_case(std::string_view line, std::optional<Precision> precision) {
  Case one;
  try {
    const json::Document document = json::parse(line);
    const Field whole{.document = &document};
    ObjectReader reader(whole);
    if (const auto id = reader.find("id")) one.id = id->node().text;
    if (precision) (void)reader.find("precision");
    one.precision = precision ? *precision : read_precision(reader);
    one.question = read_question(reader, one.precision);
    if (const auto note = reader.find("note")) one.note = read_string(*note);
    reader.refuse_unknown();
    return one;
  } catch (const Refusal& why) {
    throw RefusedCase(why, one.id);
  }
}

}  // namespace rayproof
