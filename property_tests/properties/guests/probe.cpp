#include "properties/guests/probe.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "generators/generators.hpp"
#include "properties/boundary.hpp"
#include "properties/guests/guest.hpp"

namespace rayproof {
namespace {

constexpr unsigned cases_of_family = 24;
/// Of the families of whole numbers, where most boundaries are.
constexpr unsigned cases_on_boundaries = 1200;
constexpr std::size_t cases_at_a_time = 400;
/// From fewer cases nothing follows about what a guest never does.
constexpr unsigned enough = 12;
/// As many in a row are no chance.
constexpr unsigned a_few = 6;

/// How often something was so.
struct Share {
  unsigned count = 0;
  unsigned of = 0;
  void add(bool is_so) {
    ++of;
    count += is_so ? 1 : 0;
  }
  void add(const Share& more) {
    count += more.count;
    of += more.of;
  }
  [[nodiscard]] bool is_never() const { return of >= enough && count == 0; }
  /// The same from fewer, where what is seen once is enough: a program that is asked few cases of a shape.
  [[nodiscard]] bool is_unseen() const { return of >= 3 && count == 0; }
  [[nodiscard]] bool is_always() const { return of >= enough && count == of; }
  /// Once in ten, or less: what another boundary is to blame for.
  [[nodiscard]] bool is_rarely() const { return of >= enough && 10 * count <= of; }
  /// Every time of a few, or two times in three and oftener than a coin would be so in any run.
  [[nodiscard]] bool is_mostly() const {
    if (count == of) return of >= a_few;
    return of >= enough && 3 * count >= 2 * of && count >= 0.5 * of + 2 * std::sqrt(static_cast<double>(of));
  }
};

constexpr unsigned long only_at(BoundaryPlace place) { return 1UL << static_cast<unsigned>(place); }

/// Whether the verdict is wrong, of who gives all hits or the first alone.
bool is_wrong(const Subject& guest, const Case& one, const Answer& given, bool is_first_alone) {
  Answer said = completed(guest, one, given);
  if (auto* hits = std::get_if<RayAnswer>(&said); hits != nullptr && is_first_alone) {
    hits->nearest_only = true;
    hits->hits.count = std::min<std::size_t>(hits->hits.count, 1);
  }
  return judged(one, said).wrong;
}

/// What the answers so far hold.
struct Learnt {
  Share two{}, numbers{}, contact{}, point{}, normal{}, barycentric{}, boundary{};
  /// How often it is wrong on some boundaries at once; the same of who reports the first hit alone.
  std::array<std::map<unsigned long, Share>, 2> wrong_on{};

  void add(const Subject& guest, const Case& one, const Answer& given) {
    const Answer exact = oracle::answer(one);
    if (const auto* hits = std::get_if<RayAnswer>(&given))
      add_hits(*hits, std::get<RayAnswer>(exact));
    else if (const auto* roots = std::get_if<QuadraticAnswer<double>>(&given))
      add_roots(*roots, std::get<QuadraticAnswer<double>>(exact));
    else if (std::get<Position>(exact) == Position::boundary)
      boundary.add(std::get<Position>(given) == Position::boundary);
    if (!is_exact_for_some_method(one)) return;
    for (const bool is_first_alone : {false, true}) {
      const BoundaryPlaces places = boundary_places(one, is_first_alone);
      if (places.any())
        wrong_on.at(is_first_alone ? 1 : 0)[places.to_ulong()].add(
            is_wrong(guest, one, given, is_first_alone));
    }
  }

  void put_into(const std::string& topic, Abilities& abilities) const {
    abilities.all_hits = !two.is_unseen();
    abilities.numbers = !numbers.is_never();
    abilities.contact = !contact.is_never();
    abilities.point = !point.is_never();
    abilities.normal = !normal.is_never();
    abilities.barycentric = !barycentric.is_never();
    abilities.boundary = !boundary.is_never();
    for (std::size_t place = 0; place < boundary_place_count; ++place)
      abilities.rules[place] = wrong_at(place, topic, abilities.all_hits).is_mostly();
    // Even and odd crossings leave some of a polygon's edges open, whatever one does; not all of them.
    constexpr auto edge = static_cast<std::size_t>(BoundaryPlace::edge);
    if ((topic == "polygon" || topic == "point_in_polygon") &&
        !wrong_at(edge, topic, abilities.all_hits).is_always())
      abilities.rules.reset(edge);
    if (topic == "box") put_faces_into(abilities);
    if (topic == "point_in_polygon") put_vertices_into(abilities);
    for (const auto& [places, share] : wrong_on.at(abilities.all_hits ? 0 : 1)) {
      abilities.wrong_on_boundaries += share.count;
      abilities.asked_on_boundaries += share.of;
    }
  }

 private:
  /// Where a ray runs in a face of a box, or begins on one, differences are 0 and nothing is rounded in any
  /// formula: some of these that are wrong are a rule.
  void put_faces_into(Abilities& abilities) const {
    using enum BoundaryPlace;
    for (const BoundaryPlace place : {at_origin, entering, leaving, low_face, high_face}) {
      const auto number = static_cast<std::size_t>(place);
      const Share share = wrong_at(number, "box", abilities.all_hits);
      if (share.count >= 3 && !share.is_rarely()) abilities.rules.set(number);
    }
  }

  /// Who never says that a point is on the boundary has no rule there. Who knows all that lie on sides needs
  /// no rounding to know a vertex: some that are taken for something else are a rule.
  void put_vertices_into(Abilities& abilities) const {
    using enum BoundaryPlace;
    const auto at = [&](BoundaryPlace place) {
      return wrong_at(static_cast<std::size_t>(place), "point_in_polygon", abilities.all_hits);
    };
    const unsigned on_sides =
        at(edge).count + at(level_side).count + at(upright_side).count + at(closing_side).count;
    if (on_sides == 0 && at(vertex).count >= 3) abilities.rules.set(static_cast<std::size_t>(vertex));
    if (!abilities.boundary) abilities.rules.reset();
  }

  /// How often it is wrong at a place: of the cases that lie on no other boundary, and, where the place is
  /// one of its own comparison whatever is met, on others alone that it is never wrong on.
  [[nodiscard]] Share wrong_at(std::size_t place, const std::string& topic, bool all_hits) const {
    const auto& shares = wrong_on.at(all_hits ? 0 : 1);
    const unsigned long own = 1UL << place;
    // A hit at the rim of a capped cylinder may fall between side and cap, and is nobody's fault.
    const unsigned long forgiven = topic == "cylinder" ? only_at(BoundaryPlace::edge) : 0;
    const unsigned long beside =
        topic == "point_in_polygon" ? only_at(BoundaryPlace::greatest) | only_at(BoundaryPlace::least) : 0;
    const auto is_rarely_wrong_on = [&](unsigned long places) {
      for (; places != 0; places &= places - 1) {
        const auto found = shares.find(places & -places);
        if (found == shares.end() || !found->second.is_rarely()) return false;
      }
      return true;
    };
    Share share;
    for (const auto& [places, one] : shares)
      if ((places & own) != 0 && (places & forgiven & ~own) == 0 &&
          is_rarely_wrong_on(places & ~own & ~beside))
        share.add(one);
    return share;
  }

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
    if (family.topic != guest.topic || family.is_beyond_the_digits) continue;
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
