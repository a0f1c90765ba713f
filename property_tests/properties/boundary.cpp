#include "properties/boundary.hpp"

#include <algorithm>

#include "oracle/oracle.hpp"
#include "properties/trial.hpp"

namespace rayproof {
namespace {

/// Only hits are on a boundary that belongs to the shape; a change of verdict is then at no distance.
BoundaryKind kind_of(const Case& one, const RayQuestion& asked, const RayAnswer& exact) {
  if (exact.hits.count == 0) return BoundaryKind::none;
  const auto line = std::get<RayAnswer>(oracle::answer(on_whole_line(one)));
  const auto is_end = [&](double t) { return t == asked.ray.t_min || t == asked.ray.t_max; };
  if (std::ranges::any_of(line.hits.view(), is_end)) return BoundaryKind::end;
  if (exact.contact == Contact::tangent) return BoundaryKind::tangent;
  return oracle::judge(one, RayAnswer{}).margin == 0 ? BoundaryKind::edge : BoundaryKind::none;
}

}  // namespace

BoundaryKind boundary_in(const Case& one) {
  const Answer exact = oracle::answer(one);
  if (const auto* position = std::get_if<Position>(&exact))
    return *position == Position::boundary ? BoundaryKind::edge : BoundaryKind::none;
  if (const auto* roots = std::get_if<QuadraticAnswer<double>>(&exact))
    return roots->kind == RootKind::twice ? BoundaryKind::tangent : BoundaryKind::none;
  return kind_of(one, std::get<RayQuestion>(one.question), std::get<RayAnswer>(exact));
}

bool is_exact_for_some_method(const Case& one) {
  return std::ranges::any_of(subjects(), [&](const Subject& subject) {
    return subject.topic == topic_of(one) && subject.is_exact_on != nullptr &&
           subject.contract.holds.contains(Claim::exact) && subject.is_exact_on(one);
  });
}

}  // namespace rayproof
