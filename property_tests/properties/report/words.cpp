#include "properties/report/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "case/json/number_text.hpp"
#include "properties/claims/answers.hpp"

namespace rayproof {

namespace {

std::string rough(double x) { return fmt::format("{:.4g}", x); }

/// "a sphere of radius 1 from 4500 away".
std::string things_in(const RayQuestion& asked) {
  return std::visit(
      [&]<class S>(const S& shape) {
        std::string text = std::string("a ") + ShapeFormat<S>::type;
        if constexpr (requires { ShapeFormat<S>::in_words(shape, rough); })
          text = ShapeFormat<S>::in_words(shape, rough);
        if (asked.transform) return text + " under a transform";
        if constexpr (requires { ShapeFormat<S>::middle(shape); }) {
          const double distance = glm::length(ShapeFormat<S>::middle(shape) - asked.ray.origin);
          constexpr double far_enough = 10;  // nearer, the distance says nothing
          if (distance >= far_enough) text += fmt::format(" from {} away", rough(distance));
        }
        return text;
      },
      asked.shape);
}

/// " + 70x": a term of a sum, nothing for a coefficient of 0.
std::string term(double factor, const char* power, bool is_first) {
  if (factor == 0) return "";
  const std::string sign = factor < 0 ? (is_first ? "-" : " - ") : (is_first ? "" : " + ");
  const double size = std::abs(factor);
  return sign + (size == 1 && *power != '\0' ? "" : rough(size)) + power;
}

/// "x² + 70x + 1".
std::string things_in(const Quadratic<double>& q) {
  std::string text = term(q.a, "x²", true);
  text += term(q.b, "x", text.empty());
  text += term(q.c, "", text.empty());
  return text.empty() ? "0" : text;
}

std::string things_in(const PointAndPolygon<double>& asked) {
  return fmt::format("({}, {}) and a polygon with {} vertices", rough(asked.point.x), rough(asked.point.y),
                     asked.vertices.size());
}

/// A number in the fewest digits that distinguish it from all others of the precision.
std::string shown(double number, Precision precision) {
  std::string text;
  append_number(text, number, precision);
  return text;
}

/// "8999, 9001": the t or x of an answer; the later ones of many are left out.
std::string list_of(const std::vector<double>& numbers, Precision precision) {
  constexpr std::size_t most = 2;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, numbers.size()); ++i)
    text += (i > 0 ? ", " : "") + shown(numbers[i], precision);
  return numbers.size() > most ? text + ", …" : text;
}

/// Whether both miss, or both hit at the same t, and only the contact differs.
bool differ_in_contact_alone(const Answer& got, const Answer& exact) {
  return std::holds_alternative<RayAnswer>(got) && same(got, exact) &&
         std::get<RayAnswer>(got).contact != std::get<RayAnswer>(exact).contact;
}

/// The rank at which two lists of as many numbers differ most, relative to the second one's.
std::size_t worst_rank(const std::vector<double>& got, const std::vector<double>& exact) {
  std::size_t worst = 0;
  double most = 0;
  for (std::size_t i = 0; i < got.size(); ++i) {
    const double difference = got[i] == exact[i] ? 0 : std::abs(got[i] - exact[i]) / std::abs(exact[i]);
    if (!(difference <= most)) {
      worst = i;
      most = difference;
    }
  }
  return worst;
}

/// The numbers of an answer from which a reader compares two: the one at the rank where they differ most
/// where both have as many, else all of them.
class Compared {
 public:
  Compared(const Answer& a, const Answer& b, Precision precision)
      : count_(numbers_in(a).size()), precision_(precision) {
    if (count_ == numbers_in(b).size() && count_ > 0) rank_ = worst_rank(numbers_in(a), numbers_in(b));
  }

  /// "8999, 9001", "a miss", "no root", "inside".
  [[nodiscard]] std::string outcome(const Answer& answer) const {
    if (const auto* position = std::get_if<Position>(&answer)) return name_of(*position);
    const std::vector<double> numbers = numbers_in(answer);
    if (rank_ && numbers.size() == count_) return shown(numbers[*rank_], precision_);
    if (!numbers.empty()) return list_of(numbers, precision_);
    if (std::holds_alternative<RayAnswer>(answer)) return "a miss";
    return std::get<QuadraticAnswer<double>>(answer).kind == RootKind::everything ? "every x" : "no root";
  }

  /// What an answer does with the things of its case: "hits a plane at t = 1", "misses a triangle".
  [[nodiscard]] std::string deed(const Answer& answer, const std::string& things) const {
    const std::string what = outcome(answer);
    const bool has_numbers = !numbers_in(answer).empty();
    if (std::holds_alternative<Position>(answer)) return fmt::format("says '{}' of {}", what, things);
    if (!gives_numbers(answer)) return "hits " + things;
    if (std::holds_alternative<RayAnswer>(answer))
      return has_numbers ? fmt::format("hits {} at t = {}", things, what) : fmt::format("misses {}", things);
    return has_numbers ? fmt::format("solves {} by x = {}", things, what)
                       : fmt::format("finds {} of {}", what, things);
  }

 private:
  std::size_t count_;
  Precision precision_;
  std::optional<std::size_t> rank_{};
};

/// "(0, 0, 1)", or "none".
std::string shown(const std::optional<glm::dvec3>& v) {
  return v ? fmt::format("({}, {}, {})", rough(v->x), rough(v->y), rough(v->z)) : "none";
}

/// "at the point (0, 0, 1) (exact (0, 0, 2))": what is said of the first hit.
std::string said_of_hit(Claim claim, const RayAnswer& got, const RayAnswer& exact) {
  const auto [member, before] = claim == Claim::point ? std::pair{&RayAnswer::point, "point"}
                                : claim == Claim::normal
                                    ? std::pair{&RayAnswer::normal, "normal"}
                                    : std::pair{&RayAnswer::barycentric, "barycentric coordinates"};
  // On an edge the normal of each face that meets there is right.
  const bool is_of_several = claim == Claim::normal && !exact.normal;
  return fmt::format("{} {} (exact {})", before, shown(got.*member),
                     is_of_several ? "that of a face which meets there" : shown(exact.*member));
}

}  // namespace

std::string in_words(const Finding& finding) {
  // What is done to the case before the answer of the evidence is asked.
  static const std::map<Claim, const char*> circumstances{{Claim::scaled, "once scaled"},
                                                          {Claim::reversed, "once reversed"},
                                                          {Claim::batch, "in a batch"},
                                                          {Claim::nan, "with a NaN in it"}};
  if (finding.property->claim == Claim::answers) return finding.evidence.note;
  const Answer& got = finding.evidence.got;
  const Answer& exact = finding.evidence.exact;
  const Claim claim = finding.property->claim;
  const std::string things =
      std::visit([](const auto& asked) { return things_in(asked); }, finding.one.question);
  const bool is_of_contact = claim == Claim::contact || finding.property->name == std::string_view("touch");
  if (is_of_contact || (claim == Claim::exact && differ_in_contact_alone(got, exact)))
    return fmt::format("calls the {} of {} '{}' (exact '{}')", finds_something(got) ? "hit" : "miss", things,
                       name_of(std::get<RayAnswer>(got).contact),
                       name_of(std::get<RayAnswer>(exact).contact));
  if (claim == Claim::point || claim == Claim::normal || claim == Claim::coordinates)
    return fmt::format("hits {} with the {}", things,
                       said_of_hit(claim, std::get<RayAnswer>(got), std::get<RayAnswer>(exact)));
  const auto changed = circumstances.find(claim);
  if (changed == circumstances.end() || finding.evidence.other) {
    const Compared compared(got, exact, finding.one.precision);
    // The evidence is of the other case itself.
    const std::string before = changed != circumstances.end() ? fmt::format("{}, ", changed->second)
                               : claim == Claim::moved        ? "once moved, "
                                                              : "";
    return fmt::format("{}{} (exact {})", before, compared.deed(got, things), compared.outcome(exact));
  }
  const Answer plain = finding.subject->answer(finding.one);
  const Compared compared(plain, got, finding.one.precision);
  return fmt::format("{}, but {} {} (exact {})", compared.deed(plain, things), compared.outcome(got),
                     changed->second, compared.outcome(exact));
}

}  // namespace rayproof
