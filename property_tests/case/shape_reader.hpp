#pragma once
/// \file
/// Reads whichever shape of a variant an object describes, through the shapes' ShapeFormat alone.

#include <fmt/format.h>

#include <limits>
#include <type_traits>
#include <variant>

#include "case/field.hpp"
#include "case/shape_format.hpp"

namespace rayproof {
namespace detail {

/// A shape's value is needed, but for a bool, which keeps its default where it is left out.
template <class T>
void read_shape_value(ObjectReader& reader, const char* name, Precision precision, T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    if (const auto field = reader.find(name)) read_value(*field, precision, value);
  } else {
    read_value(reader.need(name), precision, value);
  }
}

template <class Result, class Shape>
Result read_one_shape(const Field& object, Precision precision) {
  ObjectReader reader(object);
  static_cast<void>(reader.need("type"));
  Shape shape{};
  ShapeFormat<Shape>::fields(
      shape, [&](const char* name, auto& value) { read_shape_value(reader, name, precision, value); });
  reader.refuse_unknown();
  ShapeFormat<Shape>::validate(shape);
  return shape;
}

/// How many of the shape's fields the object lacks.
template <class Shape>
std::size_t count_missing(const Field& object) {
  ObjectReader reader(object);
  std::size_t missing = 0;
  Shape shape{};
  ShapeFormat<Shape>::fields(shape, [&](const char* name, auto&) { missing += reader.find(name) ? 0U : 1U; });
  return missing;
}

/// `"sphere", "plane"`: the types of the shapes, each once.
template <class... Shapes>
std::string list_of_types() {
  std::string list;
  const auto add = [&list](const char* type) {
    const std::string quoted = fmt::format("\"{}\"", type);
    if (list.find(quoted) == std::string::npos) list += (list.empty() ? "" : ", ") + quoted;
  };
  (add(ShapeFormat<Shapes>::type), ...);
  return list;
}

}  // namespace detail

/// Reads the shape that `object` describes into `shape`. Where several shapes share a type (the forms of a
/// plane), it is the one that lacks the fewest fields.
template <class... Shapes>
void read_shape(const Field& object, Precision precision, std::variant<Shapes...>& shape) {
  using Result = std::variant<Shapes...>;
  Result (*read)(const Field&, Precision) = nullptr;
  std::size_t fewest_missing = std::numeric_limits<std::size_t>::max();

  ObjectReader reader(object);
  const Field type_field = reader.need("type");
  const std::string type = read_string(type_field);
  const auto consider = [&]<class Candidate>(std::type_identity<Candidate>) {
    if (type != ShapeFormat<Candidate>::type) return;
    const std::size_t missing = detail::count_missing<Candidate>(object);
    if (missing >= fewest_missing) return;
    fewest_missing = missing;
    read = &detail::read_one_shape<Result, Candidate>;
  };
  (consider(std::type_identity<Shapes>{}), ...);

  if (read == nullptr) {
    type_field.refuse(fmt::format("is an unknown shape type, {}; known: {}", json::quote(type),
                                  detail::list_of_types<Shapes...>()));
  }
  shape = read(object, precision);
}

}  // namespace rayproof
