/// \file
/// Properties of cases in which nothing is rounded: there nothing is excused, boundaries least of all.

#include <algorithm>
#include <cmath>

#include "properties/boundary.hpp"
#include "properties/claims/promise.hpp"
#include "properties/property.hpp"

namespace rayproof {

namespace {

/// Whether a contact claimed is true, though it may say less than the exact one: nobody need distinguish an
/// edge, a vertex or a rim from the rest of the surface, nor say why a solid is missed. Where a line touches
/// the side of a cylinder at its rim, it is at the rim and tangent.
bool is_true(Contact claimed, Contact exact) {
  if (claimed == exact) return true;
  if (claimed == Contact::crossing) return exact != Contact::tangent;
  if (claimed == Contact::tangent) return exact == Contact::rim;
  return claimed == Contact::none;
}

/// Why a ray misses a plane is a part of the answer, and 'none' of the reasons is one of them.
bool is_contact_right(const Case& one, const Answer& claimed) {
  const auto* got = std::get_if<RayAnswer>(&claimed);
  if (got == nullptr || got->nearest_only) return true;
  const Contact exact = std::get<RayAnswer>(oracle::answer(one)).contact;
  return topic_of(one) == "plane" ? got->contact == exact : is_true(got->contact, exact);
}

/// The sign of a barycentric coordinate decides: so it is a quotient of exact numbers, or 1 less two of them,
/// and off by a few roundings of 1 at most.
bool are_coordinates_right(Trial& trial) {
  const auto* got = std::get_if<RayAnswer>(&trial.claimed());
  return got == nullptr || !got->barycentric || trial.details().coordinates.value_or(0) <= 4;
}

/// Each t of a case that rounds nothing is a number of its precision, and another is half an ulp away at
/// least.
bool is_exactly_right(Trial& trial) {
  const oracle::Judgement& judgement = trial.judgement();
  return !judgement.wrong && judgement.ulp < 0.25 && is_contact_right(trial.question(), trial.claimed()) &&
         are_coordinates_right(trial);
}

Ruling exact(Trial& trial) {
  const auto is_exact_on = trial.subject().is_exact_on;
  if (is_exact_on == nullptr || !is_exact_on(trial.question())) return Ruling::outside;
  return is_exactly_right(trial) ? Ruling::held : Ruling::broken;
}

Evidence show_exact(Trial& trial) {
  const oracle::Judgement& judgement = trial.judgement();
  const char* const note =
      judgement.wrong         ? "no step is rounded, and yet the verdict is wrong"
      : judgement.ulp >= 0.25 ? "no step is rounded, and yet t is not the exact one"
      : !are_coordinates_right(trial)
          ? "no step is rounded, and yet the barycentric coordinates are not the exact ones"
          : "no step is rounded, and yet the contact is not the exact one";
  return show_answer(trial, note);
}

/// Whether a subject that reports no hit but the first reports another hit of the line: it leaves out one
/// that lies on a boundary, the origin on the surface, say.
bool is_another_hit(const Case& one, const Answer& claimed) {
  const auto* got = std::get_if<RayAnswer>(&claimed);
  if (got == nullptr || !got->nearest_only || got->hits.count == 0) return false;
  const auto distance = [t = got->hits.t[0]](double hit) { return std::abs(hit - t); };
  const RayAnswer exact = std::get<RayAnswer>(oracle::answer(one));
  return distance(exact.hits.t[exact.hits.count - 1]) < distance(exact.hits.t[0]);
}

/// Whether what a guest says there is its rule; what is left to its rounding is not judged.
Ruling boundary_of_guest(Trial& trial) {
  const Abilities& able = trial.subject().abilities;
  if (able.rules.none() || !trial.in_domain()) return Ruling::outside;
  const Case& one = trial.question();
  if (!is_exact_for_some_method(one)) return Ruling::outside;
  const BoundaryPlaces places = boundary_places(one, !able.all_hits);
  if (places.none()) return Ruling::outside;
  if (!trial.judgement().wrong) return Ruling::held;
  return (places & able.rules).any() ? Ruling::broken : Ruling::outside;
}

/// Of a subject whose steps nobody knows. A verdict that is wrong by more than the bound of the best plain
/// methods is no matter of where the boundary belongs: that is the verdict's property.
Ruling boundary(Trial& trial) {
  if (!trial.subject().has_own_contract) return boundary_of_guest(trial);
  if (trial.subject().is_exact_on != nullptr || !trial.in_domain()) return Ruling::outside;
  const std::optional<double> bound = robust_bound(trial.subject().topic);
  if (!bound || !is_exact_for_some_method(trial.question())) return Ruling::outside;
  const oracle::Judgement& judgement = trial.judgement();
  if (judgement.wrong) return judgement.margin <= *bound ? Ruling::broken : Ruling::outside;
  const bool is_right = is_contact_right(trial.question(), trial.claimed()) &&
                        !is_another_hit(trial.question(), trial.claimed());
  return is_right ? Ruling::held : Ruling::broken;
}

Evidence show_boundary(Trial& trial) {
  const char* const note = trial.judgement().wrong ? "the verdict is wrong on a boundary"
                           : is_another_hit(trial.question(), trial.claimed())
                               ? "the nearest hit, on a boundary, is left out, and the next one reported"
                               : "the contact is not the exact one";
  return show_answer(trial, std::string(note) + ", though a plain method rounds nothing here");
}

}  // namespace

std::vector<Property> exact_properties() {
  return {
      {Claim::exact, "exact",
       "where no step is rounded, verdict, t and contact are exactly right, and coordinates to a rounding", 1,
       exact, show_exact},
      {Claim::exact, "boundary",
       "where a plain method rounds nothing, the boundary belongs to the shape for this one, too", 1,
       boundary, show_boundary},
  };
}

}  // namespace rayproof
