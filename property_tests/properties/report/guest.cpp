#include "properties/report/guest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "case/json/writer.hpp"
#include "properties/engine/kind.hpp"
#include "subjects/command.hpp"

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

/// The shape, and the name of the guest where it has one.
std::string label_of(const Subject& guest) {
  return guest.name == command_name ? guest.topic : guest.full_name();
}

/// "56000 cases, 1200 unsupported: findings 1, 4".
std::string line_of(const RunResult& result, const Subject& guest, const Tally& tally) {
  if (tally.cases == 0) return fmt::format("{:<16} not asked\n", label_of(guest));
  if (tally.unsupported == tally.cases)
    return fmt::format("{:<16} unsupported: the program says so of all {} cases\n", label_of(guest),
                       tally.cases);
  std::string text = fmt::format("{:<16} {} cases", label_of(guest), tally.cases);
  if (tally.unsupported > 0) text += fmt::format(", {} unsupported", tally.unsupported);
  if (tally.failures > 0) text += fmt::format(", {} without an answer", tally.failures);
  if (tally.not_asked > 0) text += fmt::format(", {} not asked after these", tally.not_asked);
  if (tally.left_out > 0) text += fmt::format(", {} left out for their sizes", tally.left_out);
  const std::vector<std::size_t> found = findings_on(result, guest);
  text += found.empty() ? ": nothing found" : fmt::format(": FINDINGS {}", fmt::join(found, ", "));
  return text + "\n";
}

bool is_one_of(const Property& property, std::initializer_list<std::string_view> names) {
  return std::ranges::find(names, property.name) != names.end();
}

/// What is never asked of a guest.
bool is_for_own_methods(const Property& property) {
  return is_one_of(property,
                   {"batch", "bounded", "sure", "exact", "robust-verdict", "robust-residual", "ulp", "nan"});
}

/// Why a property is not judged: what the guest leaves out; empty where it leaves out nothing.
std::string left_out(const Subject& guest, const Property& property) {
  const Abilities& able = guest.abilities;
  if (is_one_of(property, {"residual", "ascending"}) && !able.numbers) return "no t is given";
  if (is_one_of(property, {"contact", "touch"}) && !able.contact) return "no contact is given";
  if (is_one_of(property, {"point", "point-on-surface"}) && !able.point) return "no point is given";
  if (is_one_of(property, {"normal"}) && !able.normal) return "no normal is given";
  if (guest.topic == "triangle" && is_one_of(property, {"coordinates"}) && !able.barycentric)
    return "no barycentric coordinates are given";
  return "";
}

/// Whether it was asked on boundaries before the run, and is right on all of them.
bool is_right_on_boundaries(const Subject& guest) {
  return guest.abilities.asked_on_boundaries > 0 && guest.abilities.wrong_on_boundaries == 0;
}

/// Why the boundary of a shape is not judged.
std::string why_no_boundary(const Subject& guest) {
  const auto& [wrong, asked] =
      std::pair(guest.abilities.wrong_on_boundaries, guest.abilities.asked_on_boundaries);
  if (asked == 0) return "no verdict was given there";
  return fmt::format("{} of {} verdicts there are wrong, {}", wrong, asked,
                     guest.topic == "polygon"
                         ? "as those of a half-open one: of its sides some belong to it, as even and odd "
                           "crossings have it"
                         : "by no rule: rounding, or a fault on some of them");
}

/// "not judged: point, normal (…)", and what is judged in part; empty where nothing is left out.
std::string not_judged(const Plan& plan, const Subject& guest, const Tally& tally) {
  std::map<std::string, std::vector<std::string_view>> by_reason;
  for (std::size_t p = 0; p < properties().size(); ++p) {
    const Property& property = properties()[p];
    if (!plan.is_wanted[p] || is_for_own_methods(property)) continue;
    std::string reason = left_out(guest, property);
    if (is_one_of(property, {"boundary"}) && tally.properties[p].judged() == 0 &&
        !is_right_on_boundaries(guest))
      reason = why_no_boundary(guest);
    by_reason[reason].push_back(property.name);
  }
  by_reason.erase("");
  std::vector<std::string> parts;
  parts.reserve(by_reason.size() + 2);
  for (const auto& [reason, names] : by_reason)
    parts.push_back(fmt::format("{} ({})", fmt::join(names, ", "), reason));
  if (!guest.abilities.all_hits) parts.emplace_back("hits behind the nearest (none is given)");
  if (guest.topic == "point_in_polygon" && !guest.abilities.boundary)
    parts.emplace_back("points on the boundary (it never says so)");
  return parts.empty() ? "" : fmt::format("  not judged: {}\n", fmt::join(parts, "; "));
}

constexpr const char* never_judged =
    "never judged of a program: nan (every case sent is valid); batch, bounded, exact, robust, ulp (promises "
    "of our own methods)\n"
    "left out for their sizes: cases with numbers, or a volume between edges, beyond what a textbook's "
    "arithmetic can hold\n";

std::string judged(const Plan& plan, const Subject& guest, const Tally& tally) {
  std::vector<std::string> names;
  for (std::size_t p = 0; p < properties().size(); ++p) {
    const Property& property = properties()[p];
    if (!plan.is_wanted[p] || !left_out(guest, property).empty()) continue;
    if (tally.properties[p].judged() > 0)
      names.emplace_back(property.name);
    else if (is_one_of(property, {"boundary"}) && is_right_on_boundaries(guest))
      names.push_back(
          fmt::format("boundary (all {} verdicts there are right)", guest.abilities.asked_on_boundaries));
  }
  return names.empty() ? "" : fmt::format("  judged: {}\n", fmt::join(names, ", "));
}

}  // namespace

std::string text_guests(const Plan& plan, const RunResult& result) {
  std::string text;
  for (const Subject* guest : plan.subjects) {
    if (guest->has_own_contract) continue;
    const Tally tally = tally_of(result, *guest);
    // A library is not asked to know every shape.
    if (guest->name != command_name && tally.unsupported == tally.cases && tally.cases > 0) continue;
    text += line_of(result, *guest, tally);
    if (tally.cases > tally.unsupported)
      text += judged(plan, *guest, tally) + not_judged(plan, *guest, tally);
  }
  text += never_judged;
  std::set<std::string> given_up;  // all topics of a program give up together
  for (const Subject* guest : plan.subjects)
    if (guest->is_given_up() && given_up.insert(guest->title).second)
      text += fmt::format("{} was asked no more: {}\n", guest->title, guest->why_given_up());
  return text;
}

std::string json_guests(const Plan& plan, const RunResult& result) {
  std::string text;
  for (const Subject* guest : plan.subjects) {
    const Tally tally = tally_of(result, *guest);
    if (guest->has_own_contract || tally.cases == 0 || tally.unsupported == tally.cases) continue;
    std::vector<std::string> counts;
    for (std::size_t p = 0; p < properties().size(); ++p)
      if (plan.is_wanted[p] && tally.properties[p].judged() > 0 && left_out(*guest, properties()[p]).empty())
        counts.push_back(fmt::format("\"{}\": {}", properties()[p].name, tally.properties[p].judged()));
    JsonWriter json;
    json.member("shape").string(guest->topic);
    json.member("method").string(guest->name);
    json.member("seed").raw(std::to_string(plan.settings.seed));
    json.member("cases_each").raw(std::to_string(plan.settings.cases));
    json.member("cases").raw(std::to_string(tally.cases));
    json.member("unsupported").raw(std::to_string(tally.unsupported));
    json.member("failures").raw(std::to_string(tally.failures + tally.not_asked));
    json.member("judged").raw(fmt::format("{{{}}}", fmt::join(counts, ", ")));
    json.member("not_judged").string(not_judged(plan, *guest, tally));
    text += json.take() + "\n";
  }
  return text;
}

GuestVerdict verdict_on_guests(const Plan& plan, const RunResult& result) {
  std::uint64_t answered = 0;
  for (const Subject* guest : plan.subjects) {
    const Tally tally = tally_of(result, *guest);
    answered += tally.cases - tally.unsupported - tally.failures - tally.not_asked;
  }
  const auto lost = std::ranges::count_if(result.findings, [](const Finding& finding) {
    return finding.property->name == "digits" && kind_of(finding) == FindingKind::rounding;
  });
  const bool is_lost_alone = lost == std::ssize(result.findings);
  if (lost > 0 && is_lost_alone)
    return {
        fmt::format("a clean bill but for digits lost from afar ({} finding{}): nothing else that was judged "
                    "is wrong in {} answered cases",
                    lost, lost == 1 ? "" : "s", answered),
        true};
  if (!result.findings.empty()) {
    std::map<FindingKind, unsigned> kinds;
    for (const Finding& finding : result.findings) ++kinds[kind_of(finding)];
    std::vector<std::string> counts;
    counts.reserve(kinds.size());
    for (const auto& [kind, count] : kinds) counts.push_back(fmt::format("{} {}", count, name_of(kind)));
    return {fmt::format("{} finding{}: {}", result.findings.size(), result.findings.size() == 1 ? "" : "s",
                        fmt::join(counts, ", ")),
            false};
  }
  for (const Subject* guest : plan.subjects)
    if (guest->is_given_up()) return {"no clean bill: the program was asked no more", false};
  if (answered == 0) return {"no case was answered, so that nothing was judged", false};
  return {fmt::format("a clean bill: nothing that was judged is wrong in {} answered cases", answered), true};
}

}  // namespace rayproof
