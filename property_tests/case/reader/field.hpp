#pragma once
/// \file
/// The fields of a case as they are read: each value knows where it stands, so that a refusal can name it.

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case/case.hpp"
#include "case/json/text.hpp"

namespace rayproof {

/// One value of a case.
struct Field {
  const json::Document* document = nullptr;
  std::size_t index = 0;  ///< 0 for the case itself

  [[nodiscard]] const json::Node& node() const { return (*document)[index]; }

  /// "ray.origin[1]"; empty for the case itself.
  [[nodiscard]] std::string path() const { return json::path_to(*document, index); }

  /// Throws the Refusal "ray.origin[1] must be …": the path, then `what`.
  [[noreturn]] void refuse(std::string_view what) const;

  /// The elements of an array of `size`; `expected` says what it must be otherwise.
  [[nodiscard]] std::vector<Field> elements(std::string_view expected,
                                            std::optional<std::size_t> size = {}) const;
};

/// Hands out the fields of an object and remembers which were asked for. A name that stands there twice means
/// the last of the two.
class ObjectReader {
 public:
  /// Refuses a value that is not an object.
  explicit ObjectReader(const Field& object);

  [[nodiscard]] std::optional<Field> find(std::string_view name);
  /// Refuses the object where the field is missing, and names the misspelt one that stands in its place.
  /// Fields not asked for yet are taken for unknown here, so no name of an object may look like another's
  /// misspelling.
  [[nodiscard]] Field need(std::string_view name);
  /// Refuses the object where it has a field that was never asked for.
  void refuse_unknown() const;
  /// Whether a field that was never asked for may be a misspelling of `name`, which was.
  [[nodiscard]] bool has_misspelt(std::string_view name) const;

 private:
  struct Member {
    std::string name;
    Field field;
    bool is_known = false;  ///< asked for
  };
  /// What a member that is not known stands for: a name that was asked for and is not there.
  [[nodiscard]] std::optional<std::string> likely(const Member& member) const;
  [[noreturn]] void refuse(const Member& unknown) const;

  Field object_;
  std::vector<Member> members_{};
  std::vector<std::string> absent_{};  ///< asked for, and not there
};

[[nodiscard]] std::string read_string(const Field& field);

/// Which of the known names a string is. Refuses another as an unknown `what`, with the one most likely
/// meant.
[[nodiscard]] std::size_t read_name(const Field& field, std::string_view what,
                                    const std::vector<std::string>& known);

/// The number, rounded to the precision; may be infinite or NaN.
[[nodiscard]] double read_number(const Field& field, Precision precision);

/// The field's value, numbers rounded to the precision and finite. Overloaded for the types a shape is made
/// of.
void read_value(const Field& field, Precision precision, double& value);
void read_value(const Field& field, Precision precision, glm::dvec3& value);
void read_value(const Field& field, Precision precision, Vec2<double>& value);
void read_value(const Field& field, Precision precision, bool& value);

template <class T, std::size_t N>
void read_value(const Field& field, Precision precision, std::array<T, N>& values) {
  const std::vector<Field> elements = field.elements("must be an array of " + std::to_string(N), N);
  for (std::size_t i = 0; i < N; ++i) read_value(elements[i], precision, values[i]);
}

template <class T>
void read_value(const Field& field, Precision precision, std::vector<T>& values) {
  for (const Field& element : field.elements("must be an array")) {
    read_value(element, precision, values.emplace_back());
  }
}

}  // namespace rayproof
