#include "properties/report/guest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "properties/kind.hpp"

namespace rayproof {
namespace {

/// What was counted of a guest over all families and precisions.
Tally tally_of(const RunResult& result, const Subject& guest) {
  Tally sum;
  for (const Unit& unit : result.units)
    if (unit.subject == &guest) sum += unit.tally;
  sum.properties.resize(properties().size());
  return sum;
}

std::vector<std::size_t> findings_on(const RunResult& result, const Subject& guest) {
  std::vector<std::size_t> numbers;
  for (const Finding& finding : result.findings)
    if (finding.subject == &guest) numbers.push_back(finding.number);
  return numbers;
}

/// "56000 cases, 1200 unsupported: findings 1, 4".
std::string line_of(const RunResult& result, const Subject& guest, const Tally& tally) {
  if (tally.cases == 0) return fmt::format("{:<17}not asked\n", guest.topic);
  if (tally.unsupported == tally.cases)
    return fmt::format("{:<17}unsupported: the program says so of all {} cases\n", guest.topic, tally.cases);
  std::string text = fmt::format("{:<17}{} cases", guest.topic, tally.cases);
  if (tally.unsupported > 0) text += fmt::format(", {} unsupported", tally.unsupported);
  if (tally.failures > 0) text += fmt::format(", {} without an answer", tally.failures);
  if (tally.not_asked > 0) text += fmt::format(", {} not asked after these", tally.not_asked);
  const std::vector<std::size_t> found = findings_on(result, guest);
  text += found.empty() ? ": nothing found" : fmt::format(": FINDINGS {}", fmt::join(found, ", "));
  return text + "\n";
}

/// Why a property was judged on no case; the reasons are what the guest leaves out, or the question has not.
std::string why_not_judged(const Subject& guest, const Property& property) {
  const Abilities& able = guest.abilities;
  const auto is = [&](std::initializer_list<std::string_view> names) {
    return std::ranges::find(names, property.name) != names.end();
  };
  if (property.claim == Claim::nan) return "every case sent is valid";
  if (is({"batch", "bounded", "exact", "robust-verdict", "robust-residual", "ulp"}))
    return "asked of our own methods alone";
  if (is({"residual", "ascending"}) && !able.numbers) return "no t is given";
  if (is({"contact", "touch"}) && !able.contact) return "no contact is given";
  if (is({"point", "point-on-surface"}) && !able.point) return "no point is given";
  if (is({"normal"}) && !able.normal) return "no normal is given";
  if (is({"coordinates"}) && (guest.topic != "triangle" || !able.barycentric))
    return "no barycentric coordinates are given";
  if (is({"boundary"})) return "what it says on boundaries is its rounding's, or right";
  return "no case of the question's has it";
}

/// "not judged: point, normal (…); nan (…)", and what is judged in part.
std::string not_judged(const Plan& plan, const Subject& guest, const Tally& tally) {
  std::map<std::string, std::vector<std::string_view>> by_reason;
  for (std::size_t p = 0; p < properties().size(); ++p)
    if (plan.is_wanted[p] && tally.properties[p].judged() == 0)
      by_reason[why_not_judged(guest, properties()[p])].push_back(properties()[p].name);
  std::vector<std::string> parts;
  for (const auto& [reason, names] : by_reason)
    parts.push_back(fmt::format("{} ({})", fmt::join(names, ", "), reason));
  if (!guest.abilities.all_hits) parts.emplace_back("hits behind the nearest (none is given)");
  if (guest.topic == "point_in_polygon" && !guest.abilities.boundary)
    parts.emplace_back("points on the boundary (it never says so)");
  return fmt::format("  not judged: {}\n", fmt::join(parts, "; "));
}

std::string judged(const Plan& plan, const Tally& tally) {
  std::vector<std::string_view> names;
  for (std::size_t p = 0; p < properties().size(); ++p)
    if (plan.is_wanted[p] && tally.properties[p].judged() > 0) names.push_back(properties()[p].name);
  return names.empty() ? "" : fmt::format("  judged: {}\n", fmt::join(names, ", "));
}

}  // namespace

std::string text_guests(const Plan& plan, const RunResult& result) {
  std::string text, last_not;
  for (const Subject* guest : plan.subjects) {
    if (guest->has_own_contract) continue;
    const Tally tally = tally_of(result, *guest);
    text += line_of(result, *guest, tally);
    if (tally.cases > tally.unsupported) text += judged(plan, tally) + not_judged(plan, *guest, tally);
  }
  for (const Subject* guest : plan.subjects)
    if (guest->is_given_up())
      return text + fmt::format("{} was asked no more: {}\n", guest->title, guest->why_given_up());
  return text;
}

GuestVerdict verdict_on_guests(const Plan& plan, const RunResult& result) {
  std::uint64_t answered = 0;
  for (const Subject* guest : plan.subjects) {
    const Tally tally = tally_of(result, *guest);
    answered += tally.cases - tally.unsupported - tally.failures - tally.not_asked;
  }
  if (!result.findings.empty()) {
    std::map<FindingKind, unsigned> kinds;
    for (const Finding& finding : result.findings) ++kinds[kind_of(finding)];
    std::vector<std::string> counts;
    for (const auto& [kind, count] : kinds) counts.push_back(fmt::format("{} {}", count, name_of(kind)));
    return {fmt::format("{} findings: {}", result.findings.size(), fmt::join(counts, ", ")), false};
  }
  if (answered == 0) return {"no case was answered, so that nothing was judged", false};
  return {fmt::format("a clean bill: nothing that was judged is wrong in {} answered cases", answered), true};
}

}  // namespace rayproof
