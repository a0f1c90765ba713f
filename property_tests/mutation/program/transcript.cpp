#include "mutation/program/transcript.hpp"

#include <algorithm>
#include <bit>

namespace rayproof::mutation {

namespace {

/// Where the functions below, plain ones, read and write.
struct Clerk {
  const Subject* subject = nullptr;
  Transcript* transcript = nullptr;
};
Clerk clerk;

Answer record_answer(const Case& one) {
  return clerk.transcript->answers.emplace_back(one, clerk.subject->answer(one)).second;
}
std::vector<std::pair<double, double>> record_bounds(const Case& one) {
  return clerk.transcript->bounds.emplace_back(one, clerk.subject->bounded_hits(one)).second;
}
bool record_doubt(const Case& one) {
  return clerk.transcript->doubts.emplace_back(one, clerk.subject->is_in_doubt(one)).second;
}
bool record_exactness(const Case& one) {
  return clerk.transcript->exactness.emplace_back(one, clerk.subject->is_exact_on(one)).second;
}

bool is_identical(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
bool is_identical(const std::optional<glm::dvec3>& a, const std::optional<glm::dvec3>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return is_identical(a->x, b->x) && is_identical(a->y, b->y) && is_identical(a->z, b->z);
}
bool is_identical(const std::optional<glm::dvec2>& a, const std::optional<glm::dvec2>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return is_identical(a->x, b->x) && is_identical(a->y, b->y);
}
bool is_identical(const RayAnswer& a, const RayAnswer& b) {
  const auto same_t = [](double x, double y) { return is_identical(x, y); };
  return a.contact == b.contact && a.nearest_only == b.nearest_only &&
         std::ranges::equal(a.hits.view(), b.hits.view(), same_t) && is_identical(a.point, b.point) &&
         is_identical(a.normal, b.normal) && is_identical(a.barycentric, b.barycentric) &&
         is_identical(a.parameters, b.parameters);
}
bool is_identical(const QuadraticAnswer<double>& a, const QuadraticAnswer<double>& b) {
  return a.kind == b.kind && a.count == b.count && is_identical(a.roots[0], b.roots[0]) &&
         is_identical(a.roots[1], b.roots[1]);
}
bool is_identical(Position a, Position b) { return a == b; }
bool is_identical(const std::pair<double, double>& a, const std::pair<double, double>& b) {
  return is_identical(a.first, b.first) && is_identical(a.second, b.second);
}

}  // namespace

bool is_identical(const Answer& a, const Answer& b) {
  const auto compare = []<class A, class B>(const A& x, const B& y) {
    if constexpr (std::is_same_v<A, B>)
      return is_identical(x, y);
    else
      return false;
  };
  return std::visit(compare, a, b);
}

Subject recorded(const Subject& subject, Transcript& transcript) {
  clerk = {&subject, &transcript};
  Subject recording = subject;
  recording.answer_by(record_answer);
  if (subject.bounded_hits != nullptr) recording.bounded_hits = record_bounds;
  if (subject.is_in_doubt != nullptr) recording.is_in_doubt = record_doubt;
  if (subject.is_exact_on != nullptr) recording.is_exact_on = record_exactness;
  return recording;
}

bool repeats(const Subject& subject, const Transcript& transcript) {
  const auto same_bound = [](const auto& a, const auto& b) { return is_identical(a, b); };
  return std::ranges::all_of(
             transcript.answers,
             [&](const auto& said) { return is_identical(subject.answer(said.first), said.second); }) &&
         std::ranges::all_of(
             transcript.exactness,
             [&](const auto& said) { return subject.is_exact_on(said.first) == said.second; }) &&
         std::ranges::all_of(
             transcript.doubts,
             [&](const auto& said) { return subject.is_in_doubt(said.first) == said.second; }) &&
         std::ranges::all_of(transcript.bounds, [&](const auto& said) {
           return std::ranges::equal(subject.bounded_hits(said.first), said.second, same_bound);
         });
}

}  // namespace rayproof::mutation
