#include "case/reader/shared_fields.hpp"

#include "case/independent.hpp"

namespace rayproof {

Precision read_precision(ObjectReader& reader) {
  const auto field = reader.find("precision");
  if (!field) return Precision::float64;
  const std::string name = read_string(*field);
  if (name == "float32") return Precision::float32;
  if (name == "float64") return Precision::float64;
  field->refuse_unknown("precision", name, {"float32", "float64"});
}

glm::dmat4 read_transform(const Field& field, Precision precision) {
  constexpr glm::dvec4 last_row{0, 0, 0, 1};
  constexpr auto expected = "must be an array of 4 rows of 4 numbers";
  glm::dmat4 transform{};
  const std::vector<Field> rows = field.elements(expected, 4);
  for (glm::length_t row = 0; row < 4; ++row) {
    const std::vector<Field> row_elements = rows[static_cast<std::size_t>(row)].elements(expected, 4);
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

}  // namespace rayproof
