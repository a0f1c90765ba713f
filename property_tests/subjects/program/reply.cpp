#include "subjects/program/reply.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

#include "case/reader/field.hpp"

namespace rayproof::program {
namespace {

/// The member of an object of that name; the last where several bear it.
std::optional<Field> member(const json::Document& document, std::string_view name) {
  std::optional<Field> found;
  for (std::size_t i = 1; i < document.front().end; i = document[i].end)
    if (document[i].key.substr(1, document[i].key.size() - 2) == name) found = Field{&document, i};
  return found;
}

double number_in(const Field& field) {
  const double number = read_number(field, Precision::float64);
  if (std::isnan(number)) field.refuse("is NaN");
  return number;
}

glm::dvec3 vector_in(const Field& field) {
  const std::vector<Field> elements = field.elements("must be an array of 3 numbers", 3);
  return {number_in(elements[0]), number_in(elements[1]), number_in(elements[2])};
}

/// The numbers of a list whose elements are `{"name": number}` or, of bare lists, numbers.
std::vector<double> list_in(const Field& field, std::string_view name) {
  std::vector<double> numbers;
  for (const Field& element : field.elements("must be an array")) {
    if (element.node().kind == json::Kind::object)
      numbers.push_back(number_in(ObjectReader(element).need(name)));
    else
      numbers.push_back(number_in(element));
  }
  return numbers;
}

template <class Enum, std::size_t count>
Enum name_in(const Field& field, std::string_view what) {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (std::size_t i = 0; i < count; ++i) all.emplace_back(name_of(static_cast<Enum>(i)));
    return all;
  }();
  return static_cast<Enum>(read_name(field, what, names));
}

bool read_verdict(const json::Document& document, bool has_hits) {
  const auto verdict = member(document, "verdict");
  if (!verdict) throw Refusal("verdict", "verdict is missing");
  static const std::vector<std::string> names{"hit", "miss"};
  const bool is_hit = read_name(*verdict, "verdict", names) == 0;
  if (const auto hits = member(document, "hits"); hits && has_hits != is_hit)
    throw Refusal("hits",
                  is_hit ? "verdict is hit, and hits is empty" : "verdict is miss, and there are hits");
  return is_hit;
}

/// Whether what is hit has no normal anywhere: that which is made of 0/0 there is not looked at.
bool has_no_normal(const RayQuestion& asked) {
  const auto* sphere = std::get_if<Sphere<double>>(&asked.shape);
  return sphere != nullptr && sphere->radius == 0;
}

RayAnswer read_ray_answer(const json::Document& document, const RayQuestion& asked) {
  RayAnswer answer;
  std::vector<double> hits;
  const auto given = member(document, "hits");
  if (given) hits = list_in(*given, "t");
  if (hits.size() > answer.hits.t.size())
    throw Refusal("hits", fmt::format("there are {} hits; no line meets a shape as often", hits.size()));
  const bool is_hit = read_verdict(document, !hits.empty());
  answer.verdict_only = is_hit && !given;
  if (answer.verdict_only) hits = {std::nan("")};
  for (const double t : hits) answer.hits.push_back(t);
  const auto contact = member(document, "contact");
  answer.says_contact = contact.has_value();
  answer.contact = is_hit ? Contact::crossing : Contact::none;
  if (contact) answer.contact = name_in<Contact, 9>(*contact, "contact");
  if (const auto point = member(document, "point")) answer.point = vector_in(*point);
  if (const auto normal = member(document, "normal"); normal && !has_no_normal(asked))
    answer.normal = vector_in(*normal);
  if (const auto weights = member(document, "barycentric")) answer.barycentric = vector_in(*weights);
  return answer;
}

/// The kind of an equation with that number of roots, where none is given: no more than the count is claimed.
RootKind likely_kind(const Quadratic<double>& equation, std::size_t count) {
  if (count == 2) return RootKind::two;
  if (count == 1) return equation.a == 0 ? RootKind::linear : RootKind::twice;
  if (equation.a != 0 || equation.b != 0) return RootKind::none;
  return equation.c == 0 ? RootKind::everything : RootKind::constant;
}

/// Roots that are not given are NaN.
QuadraticAnswer<double> read_equation(const json::Document& document, const Quadratic<double>& equation) {
  QuadraticAnswer<double> answer;
  const auto kind = member(document, "kind");
  auto given = member(document, "x");
  if (!given) given = member(document, "roots");
  if (!kind && !given) throw Refusal("kind", "kind and x are both missing");
  std::vector<double> roots;
  if (given) roots = list_in(*given, "x");
  if (roots.size() > 2) throw Refusal("x", fmt::format("there are {} roots", roots.size()));
  answer.kind = kind ? name_in<RootKind, 6>(*kind, "kind") : likely_kind(equation, roots.size());
  if (!given) {
    const bool is_one = answer.kind == RootKind::twice || answer.kind == RootKind::linear;
    roots.assign(answer.kind == RootKind::two ? 2 : is_one ? 1 : 0, std::nan(""));
  }
  answer.count = roots.size();
  std::ranges::copy(roots, answer.roots.begin());
  return answer;
}

Answer read_answer(const json::Document& document, const Case& one) {
  if (const auto* equation = std::get_if<Quadratic<double>>(&one.question))
    return read_equation(document, *equation);
  if (const auto* asked = std::get_if<RayQuestion>(&one.question)) return read_ray_answer(document, *asked);
  const auto position = member(document, "position");
  if (!position) throw Refusal("position", "position is missing");
  return name_in<Position, 3>(*position, "position");
}

bool is_true(const std::optional<Field>& field) { return field && field->node().text == "true"; }

}  // namespace

ReplyLine::ReplyLine(std::string_view line) : line_(line), document_(json::parse(line)) {
  if (document_.front().kind != json::Kind::object) throw Refusal("line", "the line is not a JSON object");
}

std::optional<std::uint64_t> ReplyLine::id() const {
  const auto field = member(document_, "id");
  if (!field || field->node().kind != json::Kind::number) return std::nullopt;
  const std::string_view text = field->node().text;
  std::uint64_t id = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), id);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return id;
}

/// Without what a terminal would take for a command.
static std::string harmless(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == 0x7f) c = '?';
  return text;
}

Outcome ReplyLine::outcome(const Case& one) const {
  try {
    if (is_true(member(document_, "unsupported"))) return {.kind = OutcomeKind::unsupported};
    if (const auto error = member(document_, "error"))
      return {
          .kind = OutcomeKind::refused,
          .sentence = "gave up: " + (error->node().kind == json::Kind::string ? harmless(read_string(*error))
                                                                              : excerpt(line_))};
    return {.answer = read_answer(document_, one)};
  } catch (const Refusal& why) {
    return {.kind = OutcomeKind::nonsense,
            .sentence = fmt::format("wrote a line that is no answer: {}; the line is {}", why.what(),
                                    excerpt(line_))};
  }
}

std::optional<std::uint64_t> id_in_text(std::string_view line) {
  constexpr std::string_view key = "\"id\":";
  std::size_t at = line.find(key);
  if (at == std::string_view::npos) return std::nullopt;
  at = std::min(line.find_first_not_of(' ', at + key.size()), line.size());
  std::uint64_t id = 0;
  const auto [end, error] = std::from_chars(line.data() + at, line.data() + line.size(), id);
  return error == std::errc{} ? std::optional(id) : std::nullopt;
}

std::string excerpt(std::string_view line) {
  constexpr std::size_t longest = 160;
  std::string text;
  for (const char c : line.substr(0, longest)) text += c < ' ' || c > '~' ? '?' : c;
  return line.size() > longest ? text + " ..." : text;
}

}  // namespace rayproof::program
