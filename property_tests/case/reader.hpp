#pragma once
/// \file
/// Reads a case from a line of JSON, as the case format says.

#include <optional>
#include <string>
#include <string_view>

#include "case/case.hpp"
#include "case/shape_format.hpp"

namespace rayproof {

/// A line that is refused: why, and the id under which to report it.
class RefusedCase : public Refusal {
 public:
  RefusedCase(const Refusal& why, std::string id) : Refusal(why), id_(std::move(id)) {}

  /// The line's `id` as JSON text, empty where it has none or is not JSON.
  [[nodiscard]] const std::string& id() const { return id_; }

 private:
  std::string id_;
};

class ObjectReader;
struct Field;

/// The field `precision` of a case or a scene, float64 where it is left out.
[[nodiscard]] Precision read_precision(ObjectReader& reader);

/// An affine and regular object-to-world matrix, written by rows.
[[nodiscard]] glm::dmat4 read_transform(const Field& field, Precision precision);

/// The case on a line (without its newline), its numbers rounded to its precision and every rule of the
/// format checked after that. A precision that is given takes the place of its own. Throws a RefusedCase.
[[nodiscard]] Case read_case(std::string_view line, std::optional<Precision> precision = {});

}  // namespace rayproof
