#include "properties/diagnosis/models/hits/hits.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "properties/claims/answers.hpp"
#include "properties/diagnosis/examination/agreement.hpp"
#include "properties/diagnosis/models/plane_hit.hpp"

namespace rayproof::diagnosis {
namespace {

const RayAnswer* hit_of(const Answer& exact) {
  const auto* answer = std::get_if<RayAnswer>(&exact);
  return answer != nullptr && answer->hits.count > 0 ? answer : nullptr;
}

}  // namespace

Answers never_hits(const Case& /*one*/, const Answer& exact) {
  if (!finds_something(exact)) return {};
  if (std::holds_alternative<Position>(exact)) return {Position::outside};
  if (std::holds_alternative<RayAnswer>(exact)) return {RayAnswer{}};
  return {QuadraticAnswer<double>{RootKind::none, 0, {}}};
}

std::optional<bool> always_hits(const Case& /*one*/, const Answer& got, const Answer& exact) {
  if (finds_something(exact)) return std::nullopt;
  return finds_something(got);
}

std::optional<bool> are_unsorted(const Case& one, const Answer& got, const Answer& exact) {
  std::vector<double> numbers = numbers_in(got);
  if (std::ranges::is_sorted(numbers)) return std::nullopt;
  std::ranges::sort(numbers);
  const std::vector<double> exactly = numbers_in(exact);
  return std::ranges::equal(numbers, exactly,
                            [&](double x, double y) { return are_close(one.precision, x, y, 0); });
}

std::optional<bool> not_nearest(const Case& one, const Answer& got, const Answer& exact) {
  const auto* ray = std::get_if<RayAnswer>(&got);
  const std::vector<double> hits = numbers_in(exact);
  if (ray == nullptr || !ray->nearest_only || ray->hits.count != 1 || hits.size() < 2) return std::nullopt;
  if (are_close(one.precision, hits[0], hits[1], 0)) return std::nullopt;
  const double t = ray->hits.t[0];
  if (are_close(one.precision, t, hits[0], 0)) return std::nullopt;
  return are_close(one.precision, t, hits[1], 0);
}

Answers descending(const Case& /*one*/, const Answer& exact) {
  if (numbers_in(exact).size() < 2) return {};
  Answer turned = exact;
  if (auto* ray = std::get_if<RayAnswer>(&turned))
    std::swap(ray->hits.t[0], ray->hits.t[1]);
  else
    std::ranges::reverse(std::get<QuadraticAnswer<double>>(turned).roots);
  return {turned};
}

Answers plus_root_first(const Case& one, const Answer& exact) {
  const auto* equation = std::get_if<Quadratic<double>>(&one.question);
  return equation != nullptr && equation->a > 0 ? descending(one, exact) : Answers{};
}

Answers minus_root_first(const Case& one, const Answer& exact) {
  const auto* equation = std::get_if<Quadratic<double>>(&one.question);
  return equation != nullptr && equation->a < 0 ? descending(one, exact) : Answers{};
}

Answers farthest_alone(const Case& /*one*/, const Answer& exact) {
  const RayAnswer* answer = hit_of(exact);
  if (answer == nullptr || answer->hits.count < 2) return {};
  RayAnswer last;
  last.hits.push_back(answer->hits.t.at(answer->hits.count - 1));
  return {last};
}

Answers smallest_alone(const Case& one, const Answer& exact) {
  const RayAnswer* answer = hit_of(exact);
  if (answer == nullptr || answer->hits.count < 2) return {};
  const bool is_first = std::abs(answer->hits.t[0]) <= std::abs(answer->hits.t[1]);
  return is_first ? Answers{} : farthest_alone(one, exact);
}

Answers first_alone(const Case& /*one*/, const Answer& exact) {
  if (numbers_in(exact).size() < 2) return {};
  Answer first = exact;
  if (auto* ray = std::get_if<RayAnswer>(&first))
    ray->hits.count = 1;
  else
    std::get<QuadraticAnswer<double>>(first).count = 1;
  return {first};
}

namespace {

/// Both numbers of the answer are one of them; hits that are made so before the interval is looked at.
Answers both_are(std::size_t which, const Case& one, const Answer& exact) {
  const RayQuestion* asked = ray_question(one);
  RayAnswer line;
  if (asked != nullptr && (line = hits_of_line(one)).hits.count == 2) {
    line.hits.t.fill(line.hits.t.at(which));
    return {hits_where(line, [&](double t) { return in_interval(asked->ray, t); })};
  }
  const auto* roots = std::get_if<QuadraticAnswer<double>>(&exact);
  if (roots == nullptr || roots->count != 2) return {};
  QuadraticAnswer<double> twice = *roots;
  twice.roots.fill(roots->roots.at(which));
  return {twice};
}

}  // namespace

Answers near_hits_merged(const Case& /*one*/, const Answer& exact, double apart) {
  const std::vector<double> given = numbers_in(exact);
  if (given.size() < 2 || !(given[1] - given[0] < apart)) return {};
  const auto* hits = std::get_if<RayAnswer>(&exact);
  if (hits == nullptr) {
    Answers doubles;
    for (const double x : {given[0], std::midpoint(given[0], given[1]), given[1]})
      doubles.emplace_back(QuadraticAnswer<double>{RootKind::twice, 1, {x}});
    return doubles;
  }
  RayAnswer merged = *hits;
  merged.hits.count = 1;
  return {merged};
}

Answers nearest_twice(const Case& one, const Answer& exact) { return both_are(0, one, exact); }
Answers farthest_twice(const Case& one, const Answer& exact) { return both_are(1, one, exact); }

Answers root_alone(const Case& /*one*/, const Answer& exact) {
  const auto* roots = std::get_if<QuadraticAnswer<double>>(&exact);
  if (roots == nullptr || roots->kind != RootKind::two) return {};
  Answers answers;
  for (const RootKind kind : {RootKind::twice, RootKind::two, RootKind::linear})
    for (const double x : roots->roots) answers.emplace_back(QuadraticAnswer<double>{kind, 1, {x}});
  return answers;
}

Answers double_hit_twice(const Case& /*one*/, const Answer& exact) {
  Answer twice = exact;
  if (auto* ray = std::get_if<RayAnswer>(&twice)) {
    if (ray->hits.count != 1 || ray->contact != Contact::tangent) return {};
    ray->hits.push_back(ray->hits.t[0]);
    return {twice};
  }
  auto* roots = std::get_if<QuadraticAnswer<double>>(&twice);
  if (roots == nullptr || roots->kind != RootKind::twice) return {};
  const double x = roots->roots[0];
  return {QuadraticAnswer<double>{RootKind::two, 2, {x, x}},
          QuadraticAnswer<double>{RootKind::twice, 2, {x, x}},
          QuadraticAnswer<double>{RootKind::two, 1, {x}}};
}

Answers entry_and_exit_at_one_t(const Case& one, const Answer& exact) {
  const auto* given = std::get_if<RayAnswer>(&exact);
  if (given == nullptr || given->hits.count != 1 || lies_in_a_plane(one)) return {};
  if (hits_of_line(one).hits.count != 1) return {};
  RayAnswer twice = *given;
  twice.hits.push_back(given->hits.t[0]);
  return {twice};
}

Answers single_hit_twice(const Case& /*one*/, const Answer& exact) {
  const RayAnswer* answer = hit_of(exact);
  if (answer == nullptr || answer->hits.count != 1 || answer->contact != Contact::crossing) return {};
  RayAnswer twice = *answer;
  twice.hits.push_back(answer->hits.t[0]);
  return {twice};
}

}  // namespace rayproof::diagnosis
