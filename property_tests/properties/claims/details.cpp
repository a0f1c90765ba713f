/// \file
/// Properties of what an answer says of its first hit beside t: point, normal, barycentric coordinates,
/// contact.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/vector_relational.hpp>

#include "properties/boundary.hpp"
#include "properties/claims/place_of_point.hpp"
#include "properties/claims/promise.hpp"
#include "properties/property.hpp"

namespace rayproof {

namespace {

/// All of them are judged on the same cases, so that the oracle is asked once.
constexpr unsigned details_every = 4;

/// An error of a trial's first hit beside its bound; nothing where there is none to judge, or no promise.
struct ErrorOfHit {
  double error, bound;
};
using Measure = std::optional<ErrorOfHit> (*)(Trial&);

std::optional<ErrorOfHit> measured(const std::optional<double>& error, double bound) {
  if (!error || std::isinf(bound)) return std::nullopt;
  return ErrorOfHit{*error, bound};
}

std::optional<ErrorOfHit> of_point(Trial& trial) {
  if (const double excess = excess_of_place(trial); excess > 1) return ErrorOfHit{excess, 1};
  const double allowed =
      trial.subject().has_own_contract
          ? 1
          : allowed_of_point(trial.question(), std::get<RayAnswer>(trial.claimed()).hits.t[0],
                             trial.details().condition);
  return measured(trial.details().point, allowed * trial.subject().contract.hit.point.promised);
}
/// No farther than the residual of t and the error of the point together.
std::optional<ErrorOfHit> of_surface(Trial& trial) {
  return measured(trial.details().surface, promised_surface(trial));
}
std::optional<ErrorOfHit> of_normal(Trial& trial) {
  const double allowed =
      trial.subject().has_own_contract
          ? 1
          : allowed_of_normal(trial.question(), trial.judgement().far, trial.judgement().residual);
  return measured(trial.details().normal, allowed * trial.subject().contract.hit.normal.promised);
}
std::optional<ErrorOfHit> of_coordinates(Trial& trial) {
  const Subject& subject = trial.subject();
  const bool promises_rounding = subject.contract.holds.contains(Claim::rounded) &&
                                 (!is_transformed(trial.question()) || subject.takes_transforms);
  const auto& asked = std::get<RayQuestion>(trial.question().question);
  if (subject.has_own_contract && std::get<RayAnswer>(trial.claimed()).parameters &&
      !std::holds_alternative<ParametricPlane>(asked.shape))
    return ErrorOfHit{HUGE_VAL, subject.contract.hit.coordinates.promised};  // there are none
  if (promises_rounding && trial.details().coordinates && !trial.details().coordinates_are_rounded)
    return ErrorOfHit{HUGE_VAL, subject.contract.hit.coordinates.promised};
  return measured(trial.error_of_coordinates(), trial.subject().contract.hit.coordinates.promised);
}

/// What a guest does not say is not judged; of others it is a part of the answer.
template <auto member>
bool is_judged(Trial& trial) {
  if (trial.subject().has_own_contract) return true;
  const auto* claimed = std::get_if<RayAnswer>(&trial.claimed());
  return claimed != nullptr && (claimed->*member).has_value();
}

/// Which of the two faces of a box without thickness a guest means by a hit is its own affair.
bool is_flat_box_of_guest(const Trial& trial) {
  if (trial.subject().has_own_contract) return false;
  const auto& asked = std::get<RayQuestion>(trial.question().question);
  const auto* box = std::get_if<Box<double>>(&asked.shape);
  return box != nullptr && glm::any(glm::equal(box->min, box->max));
}

/// A guest's hit that lies beside the surface is a finding by itself: the normal that it gives there is none.
bool is_wrong_hit_of_guest(Trial& trial) {
  if (trial.subject().has_own_contract) return false;
  const oracle::Judgement& judgement = trial.judgement();
  const Promise promise = promise_for(trial);
  return judgement.wrong ? judgement.margin > promise.verdict : judgement.residual > promise.residual;
}

template <Measure measure, auto member>
Ruling is_within(Trial& trial) {
  if (!is_judged<member>(trial) || !trial.in_domain_of_details()) return Ruling::outside;
  if (measure == of_normal && (is_flat_box_of_guest(trial) || is_wrong_hit_of_guest(trial)))
    return Ruling::outside;
  const auto found = measure(trial);
  if (!found) return Ruling::outside;
  return found->error <= found->bound ? Ruling::held : Ruling::broken;
}

template <Measure measure>
double excess_of(Trial& trial) {
  const auto found = measure(trial);
  return found ? found->error / found->bound : 0;
}

/// The whole line with as many hits as its contact says: what is wrong with it where the contact is.
oracle::Judgement of_line(Trial& trial, bool is_tangent) {
  const Case line = on_whole_line(trial.question());
  RayAnswer claimed;
  const double t = std::get<RayAnswer>(trial.claimed()).hits.t[0];
  for (int i = 0; i < (is_tangent ? 1 : 2); ++i) claimed.hits.push_back(t);
  return oracle::judge(line, claimed);
}

/// Whether a hit is so far from every edge, and end of the interval, that no rounding puts it there.
bool is_far_inside(const Trial& trial, double band) {
  constexpr double far = 1024;
  const double reach = std::max(band, robust_bound(trial.subject().topic).value_or(band));
  return oracle::judge(trial.question(), RayAnswer{}).margin > far * reach;
}

/// A method need not say more of a hit than that there is one; what it says more than that must be so. One
/// hit or two on the line is a verdict, for which the same band holds. Which of a figure's places a guest's
/// rounding takes a hit for is judged where a plain method rounds nothing, and far from the edges.
Ruling touch(Trial& trial) {
  const auto* claimed = std::get_if<RayAnswer>(&trial.claimed());
  if (claimed == nullptr || claimed->hits.count == 0 || !trial.in_domain()) return Ruling::outside;
  if (!claimed->says_contact || claimed->verdict_only) return Ruling::outside;
  const double band = promise_for(trial).verdict;
  if (std::isinf(band) || trial.judgement().wrong) return Ruling::outside;
  const Contact exact = *trial.details().contact;
  if (claimed->contact == exact) return Ruling::held;
  const bool is_touch = claimed->contact == Contact::tangent || exact == Contact::tangent;
  const bool may_round = !trial.subject().has_own_contract && !is_exact_for_some_method(trial.question());
  if (!is_touch) {
    const bool is_open = may_round && !(exact == Contact::crossing && is_far_inside(trial, band));
    return claimed->contact == Contact::crossing || is_open ? Ruling::held : Ruling::broken;
  }
  if (exact == Contact::rim) return Ruling::held;  // where a line touches the side it is both
  const oracle::Judgement of_count = of_line(trial, claimed->contact == Contact::tangent);
  const bool is_excused = band > 0 && of_count.margin <= band;
  return !of_count.wrong || is_excused ? Ruling::held : Ruling::broken;
}

std::string in_words(const glm::dvec3& v) { return fmt::format("[{:.9g}, {:.9g}, {:.9g}]", v.x, v.y, v.z); }

template <std::optional<glm::dvec3> RayAnswer::*member>
Evidence show(Trial& trial, const char* name, const std::string& error) {
  const auto exact = std::get<RayAnswer>(oracle::answer(trial.question())).*member;
  return show_answer(trial, fmt::format("the {} of the first hit is {}, {}; the exact one is {}", name,
                                        in_words(*(std::get<RayAnswer>(trial.claimed()).*member)), error,
                                        exact ? in_words(*exact) : "that of a face which meets there"));
}

Evidence show_point(Trial& trial) {
  if (excess_of_place(trial) > 1)
    return show<&RayAnswer::point>(trial, "point",
                                   "another hit of the line than the nearest in the interval");
  return show<&RayAnswer::point>(
      trial, "point", fmt::format("{:.3g} contract units from the ray at t", *trial.details().point));
}
Evidence show_surface(Trial& trial) {
  return show<&RayAnswer::point>(
      trial, "point", fmt::format("{:.3g} contract units from the surface", *trial.details().surface));
}
Evidence show_normal(Trial& trial) {
  return show<&RayAnswer::normal>(
      trial, "normal", fmt::format("{:.3g} contract units from the surface's at t", *trial.details().normal));
}
/// Of a plane's hit, whose coordinates are its two parameters, and which only a parametric one has.
Evidence show_parameters(Trial& trial, const glm::dvec2& given) {
  const auto exact = std::get<RayAnswer>(oracle::answer(trial.question())).parameters;
  const std::string right =
      exact ? fmt::format("the exact ones are [{:.9g}, {:.9g}]", exact->x, exact->y) : "the plane has none";
  return show_answer(trial, fmt::format("the parameters of the first hit are [{:.9g}, {:.9g}]; {}", given.x,
                                        given.y, right));
}
Evidence show_coordinates(Trial& trial) {
  const auto& claimed = std::get<RayAnswer>(trial.claimed());
  if (claimed.parameters) return show_parameters(trial, *claimed.parameters);
  if (!claimed.barycentric) return show_answer(trial, "the first hit has no coordinates");
  return show<&RayAnswer::barycentric>(trial, "barycentric triple",
                                       fmt::format("off by {:.3g} ε", *trial.details().coordinates));
}
Evidence show_touch(Trial& trial) {
  return show_answer(trial, fmt::format("the first hit is called {}, and is {}",
                                        name_of(std::get<RayAnswer>(trial.claimed()).contact),
                                        name_of(*trial.details().contact)));
}

}  // namespace

std::vector<Property> details_properties() {
  return {
      {Claim::point, "touch",
       "a hit is called tangent, edge, vertex or rim only where it is, outside the band", details_every,
       touch, show_touch},
      {Claim::point, "point", "the point of the first hit is the ray's at t to the promised bound",
       details_every, is_within<of_point, &RayAnswer::point>, show_point, excess_of<of_point>},
      {Claim::point, "point-on-surface",
       "the point of the first hit is no farther from the surface than promised", details_every,
       is_within<of_surface, &RayAnswer::point>, show_surface, excess_of<of_surface>},
      {Claim::normal, "normal",
       "the normal of the first hit is the surface's, of unit length, on the right side", details_every,
       is_within<of_normal, &RayAnswer::normal>, show_normal, excess_of<of_normal>},
      {Claim::coordinates, "coordinates",
       "the barycentric coordinates of a hit are the exact ones to their bound, or rounded once where t is",
       details_every, is_within<of_coordinates, &RayAnswer::barycentric>, show_coordinates,
       excess_of<of_coordinates>},
  };
}

}  // namespace rayproof
