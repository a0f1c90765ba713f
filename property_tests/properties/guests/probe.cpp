#include "properties/guests/probe.hpp"

#include <array>
#include <bit>
#include <cmath>

#include "generators/generators.hpp"
#include "properties/boundary.hpp"
#include "properties/trial.hpp"

namespace rayproof {
namespace {

constexpr unsigned cases_of_family = 24;
/// Of the families of whole numbers, where most boundaries are.
constexpr unsigned cases_on_boundaries = 1200;
constexpr std::size_t cases_at_a_time = 400;
/// From fewer cases nothing follows about what a guest never does.
constexpr unsigned enough = 12;

/// How often something was so.
struct Share {
  unsigned count = 0;
  unsigned of = 0;
  void add(bool is_so) {
    ++of;
    count += is_so ? 1 : 0;
  }
  [[nodiscard]] bool is_never() const { return of >= enough && count == 0; }
  [[nodiscard]] bool is_always() const { return of >= enough && count == of; }
  /// Two times in three, and oftener than a coin would be so in any run.
  [[nodiscard]] bool is_mostly() const {
    return of >= enough && 3 * count >= 2 * of && count >= 0.5 * of + 2 * std::sqrt(static_cast<double>(of));
  }
};

/// What the answers so far hold.
struct Learnt {
  Share two{}, numbers{}, contact{}, point{}, normal{}, barycentric{}, boundary{};
  /// By BoundaryPlace: of cases that lie on that one alone; the same of who reports the first hit alone.
  std::array<std::array<Share, boundary_place_count>, 2> wrong_on{};

  void add(const Subject& guest, const Case& one, const Answer& given) {
    const Answer exact = oracle::answer(one);
    if (const auto* hits = std::get_if<RayAnswer>(&given))
      add_hits(*hits, std::get<RayAnswer>(exact));
    else if (const auto* roots = std::get_if<QuadraticAnswer<double>>(&given))
      add_roots(*roots, std::get<QuadraticAnswer<double>>(exact));
    else if (std::get<Position>(exact) == Position::boundary)
      boundary.add(std::get<Position>(given) == Position::boundary);
    if (!is_exact_for_some_method(one)) return;
    Trial trial(guest, one);
    trial.know({.answer = given}, {});
    for (const bool is_first_alone : {false, true}) {
      const BoundaryPlaces places = boundary_places(one, is_first_alone);
      if (places.count() == 1)
        wrong_on.at(is_first_alone ? 1 : 0)
            .at(static_cast<std::size_t>(std::countr_zero(places.to_ulong())))
            .add(trial.judgement().wrong);
    }
  }

  void put_into(const std::string& topic, Abilities& abilities) const {
    abilities.all_hits = !two.is_never();
    abilities.numbers = !numbers.is_never();
    abilities.contact = !contact.is_never();
    abilities.point = !point.is_never();
    abilities.normal = !normal.is_never();
    abilities.barycentric = !barycentric.is_never();
    abilities.boundary = !boundary.is_never();
    for (std::size_t place = 0; place < boundary_place_count; ++place)
      abilities.rules[place] = wrong_on.at(abilities.all_hits ? 0 : 1).at(place).is_mostly();
    // Even and odd crossings leave some of a polygon's edges open, whatever one does; not all of them.
    constexpr auto edge = static_cast<std::size_t>(BoundaryPlace::edge);
    if ((topic == "polygon" || topic == "point_in_polygon") &&
        !wrong_on.at(abilities.all_hits ? 0 : 1).at(edge).is_always())
      abilities.rules.reset(edge);
    if (topic == "point_in_polygon" && !abilities.boundary) abilities.rules.reset();
  }

 private:
  void add_hits(const RayAnswer& given, const RayAnswer& exact) {
    contact.add(given.says_contact);
    if (given.hits.count == 0 || exact.hits.count == 0) return;
    if (exact.hits.count > 1) two.add(given.hits.count > 1);
    numbers.add(!given.verdict_only);
    point.add(given.point.has_value());
    normal.add(given.normal.has_value());
    barycentric.add(given.barycentric.has_value());
  }
  void add_roots(const QuadraticAnswer<double>& given, const QuadraticAnswer<double>& exact) {
    if (exact.count > 1) two.add(given.count > 1);
    if (given.count > 0) numbers.add(!std::isnan(given.roots[0]));
  }
};

std::vector<Case> cases_for(const Subject& guest, std::uint64_t seed, Precision precision) {
  std::vector<Case> cases;
  for (const Family& family : families()) {
    if (family.topic != guest.topic) continue;
    const unsigned count = family.name == "whole" ? cases_on_boundaries : cases_of_family;
    for (unsigned k = 0; k < count; ++k) cases.push_back(family.generate(combine(seed, k), precision));
  }
  std::erase_if(cases, [&](const Case& one) { return !is_for_guest(guest, one); });
  return cases;
}

}  // namespace

std::vector<Failure> learn_abilities(Subject& guest, std::uint64_t seed,
                                     const std::vector<Precision>& precisions,
                                     const std::atomic<bool>& stop) {
  std::vector<Failure> failures;
  if (guest.has_own_contract) return failures;
  Learnt learnt;
  for (const Precision precision : precisions) {
    const std::vector<Case> cases = cases_for(guest, seed, precision);
    for (std::size_t begin = 0; begin < cases.size() && failures.empty(); begin += cases_at_a_time) {
      if (stop || guest.is_given_up()) return failures;
      const auto some = std::span(cases).subspan(begin, std::min(cases_at_a_time, cases.size() - begin));
      std::vector<Outcome> outcomes(some.size());
      guest.start()->answer(some, outcomes);
      for (std::size_t i = 0; i < some.size(); ++i) {
        if (outcomes[i].is_answered()) learnt.add(guest, some[i], outcomes[i].answer);
        if (outcomes[i].is_failure()) failures.push_back({guest.full_name(), some[i], outcomes[i]});
      }
    }
  }
  learnt.put_into(guest.topic, guest.abilities);
  return failures;
}

}  // namespace rayproof
