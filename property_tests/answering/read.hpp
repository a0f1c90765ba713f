#pragma once
/// \file
/// A line of the case format, known to be valid, as a case.

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "answering/line.hpp"
#include "case/case.hpp"
#include "case/json/parse_number.hpp"

namespace rayproof::answering {

/// The members of one object, to be found by name.
class ObjectMembers {
 public:
  explicit ObjectMembers(std::string_view object) {
    each_member(object, [this](std::string_view name, std::string_view value) {
      if (count_ < members_.size()) members_[count_++] = {name, value};
    });
  }

  /// The value as it stands; empty where there is none of that name.
  [[nodiscard]] std::string_view find(std::string_view name) const {
    for (std::size_t i = 0; i < count_; ++i)
      if (members_[i].name == name) return members_[i].value;
    return {};
  }

 private:
  struct FoundValue {
    std::string_view name, value;
  };
  std::array<FoundValue, 12> members_{};  // more than any object of the format has
  std::size_t count_ = 0;
};

/// Reads the values of a case in its precision: each number to double, then to float where it is float32.
struct ValueReader {
  Precision precision;

  void read(std::string_view text, double& number) const {
    const auto parsed = parse_number(unquoted(text));
    if (!parsed) throw std::invalid_argument("the line has something else where a number should stand");
    number = precision == Precision::float32 ? static_cast<double>(static_cast<float>(*parsed)) : *parsed;
  }
  void read(std::string_view text, bool& value) const { value = text == "true"; }
  void read(std::string_view text, glm::dvec3& vector) const {
    int i = 0;
    each_value(text, [&](std::string_view one) {
      if (i < 3) read(one, vector[i++]);
    });
  }
  void read(std::string_view text, Vec2<double>& vector) const {
    int i = 0;
    each_value(text, [&](std::string_view one) { read(one, i++ == 0 ? vector.x : vector.y); });
  }
  template <class E, std::size_t N>
  void read(std::string_view text, std::array<E, N>& values) const {
    std::size_t i = 0;
    each_value(text, [&](std::string_view one) {
      if (i < N) read(one, values[i++]);
    });
  }
  template <class E>
  void read(std::string_view text, std::vector<E>& values) const {
    values.clear();
    each_value(text, [&](std::string_view one) { read(one, values.emplace_back()); });
  }

  /// The fields of a shape, or of a question without a ray; false where one is missing.
  template <class S>
  [[nodiscard]] bool read_fields(const ObjectMembers& members, S& shape) const {
    bool is_whole = true;
    ShapeFormat<S>::fields(shape, [&]<class V>(const char* name, V& value) {
      const std::string_view text = members.find(name);
      if (!text.empty()) read(text, value);
      is_whole = is_whole && (!text.empty() || std::is_same_v<V, bool>);
    });
    return is_whole;
  }

  /// Whichever of the shapes the object describes; forms of one type differ in their fields.
  template <class... Shapes>
  void read_shape(std::string_view object, std::variant<Shapes...>& shape) const {
    const ObjectMembers members(object);
    const std::string_view type = unquoted(members.find("type"));
    const auto try_one = [&]<class S>(std::type_identity<S>) {
      if (type != ShapeFormat<S>::type) return false;
      S candidate{};
      if (!read_fields(members, candidate)) return false;
      shape = std::move(candidate);
      return true;
    };
    if (!(try_one(std::type_identity<Shapes>{}) || ...))
      throw std::invalid_argument("the line has an unknown shape");
  }

  void read_ray(std::string_view object, Ray<double>& ray) const {
    ray = {};
    each_member(object, [&](std::string_view name, std::string_view value) {
      if (name == "origin") read(value, ray.origin);
      if (name == "direction") read(value, ray.direction);
      if (name == "t_min") read(value, ray.t_min);
      if (name == "t_max") read(value, ray.t_max);
    });
  }

  /// The rows of an affine matrix into GLM's columns.
  void read_transform(std::string_view rows, glm::dmat4& transform) const {
    int row = 0;
    each_value(rows, [&](std::string_view numbers) {
      int column = 0;
      each_value(numbers, [&](std::string_view one) {
        if (row < 4 && column < 4) read(one, transform[column++][row]);
      });
      ++row;
    });
  }

  [[nodiscard]] Question read_question(const ObjectMembers& members) const {
    const auto without_ray = [&]<class Query>(Query question) -> Question {
      if (!read_fields(members, question)) throw std::invalid_argument("the line lacks a field");
      return question;
    };
    const std::string_view query = unquoted(members.find("query"));
    if (query == "quadratic") return without_ray(Quadratic<double>{});
    if (query == "point_in_polygon") return without_ray(PointAndPolygon<double>{});
    RayQuestion question{};
    read_ray(members.find("ray"), question.ray);
    read_shape(members.find("shape"), question.shape);
    const std::string_view rows = members.find("transform");
    if (!rows.empty()) read_transform(rows, question.transform.emplace());
    return question;
  }
};

/// Reads a valid line into `one`, whose id it sets before anything can fail. What is no case throws
/// std::invalid_argument; which it is that the format refuses, only `read_case` knows.
inline void read_line(std::string_view line, Case& one) {
  const ObjectMembers members(line);
  one.id = members.find("id");
  const bool is_float = unquoted(members.find("precision")) == "float32";
  one.precision = is_float ? Precision::float32 : Precision::float64;
  one.question = ValueReader{one.precision}.read_question(members);
}

}  // namespace rayproof::answering
