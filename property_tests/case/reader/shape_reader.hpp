#pragma once
/// \file
/// Reads whichever shape of a variant an object describes, through the shapes' ShapeFormat alone.

#include <algorithm>
#include <limits>
#include <type_traits>
#include <variant>

#include "case/reader/field.hpp"
#include "case/shape_format.hpp"

namespace rayproof {

/// The fields of a shape, or of a question without a ray, in the order of the format. Each is needed but for
/// a bool, which keeps its default where it is left out.
template <class Shape>
[[nodiscard]] Shape read_fields(ObjectReader& reader, Precision precision) {
  Shape shape{};
  ShapeFormat<Shape>::fields(shape, [&]<class T>(const char* name, T& value) {
    const auto field = std::is_same_v<T, bool> ? reader.find(name) : reader.need(name);
    if (field) read_value(*field, precision, value);
  });
  return shape;
}

namespace detail {

template <class Result, class Shape>
Result read_one_shape(const Field& object, Precision precision) {
  ObjectReader reader(object);
  static_cast<void>(reader.need("type"));
  auto shape = read_fields<Shape>(reader, precision);
  reader.refuse_unknown();
  ShapeFormat<Shape>::validate(shape);
  return shape;
}

/// How far the object is from the shape: 16 for each field that the shape needs and the object lacks; where
/// `guesses`, 8 for each that only seems to be misspelt. One less for each that is there decides between
/// shapes that lack as many.
template <class Shape>
int distance_from(const Field& object, bool guesses) {
  ObjectReader reader(object);
  int distance = 0;
  Shape shape{};
  ShapeFormat<Shape>::fields(shape, [&]<class T>(const char* name, T&) {
    if (std::is_same_v<T, bool>) return;
    const bool is_there = reader.find(name).has_value();
    distance += is_there ? -1 : guesses && reader.has_misspelt(name) ? 8 : 16;
  });
  return distance;
}

/// The types of the shapes, each once.
template <class... Shapes>
std::vector<std::string> list_of_types() {
  std::vector<std::string> types;
  const auto add = [&types](const char* type) {
    if (std::find(types.begin(), types.end(), type) == types.end()) types.emplace_back(type);
  };
  (add(ShapeFormat<Shapes>::type), ...);
  return types;
}

}  // namespace detail

/// Reads the shape that `object` describes into `shape`. Where several shapes share a type (the forms of a
/// plane), it is the one that lacks the fewest fields, of which one that is there misspelt counts half; of
/// those, the one of which the most are there.
template <class... Shapes>
void read_shape(const Field& object, Precision precision, std::variant<Shapes...>& shape) {
  using Result = std::variant<Shapes...>;
  Result (*read)(const Field&, Precision) = nullptr;
  int nearest = std::numeric_limits<int>::max();

  ObjectReader reader(object);
  static const std::vector<std::string> types = detail::list_of_types<Shapes...>();
  const std::string& type = types[read_name(reader.need("type"), "shape type", types)];
  const auto consider = [&]<class Candidate>(std::type_identity<Candidate>, bool guesses) {
    if (type != ShapeFormat<Candidate>::type) return;
    const int distance = detail::distance_from<Candidate>(object, guesses);
    if (distance >= nearest) return;
    nearest = distance;
    read = &detail::read_one_shape<Result, Candidate>;
  };
  (consider(std::type_identity<Shapes>{}, false), ...);
  if (nearest > 0) (consider(std::type_identity<Shapes>{}, true), ...);

  shape = read(object, precision);
}

}  // namespace rayproof
