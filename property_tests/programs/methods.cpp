/// \file
/// rayproof methods: every method, where it comes from and what it promises.

#include <algorithm>
#include <cmath>
#include <rayproof/topics.hpp>
#include <system_error>

#include "case/json/ordered.hpp"
#include "command_line/command_line.hpp"
#include "subjects/subject.hpp"

namespace {

using Json = nlohmann::ordered_json;
using namespace rayproof;

/// JSON has no infinity: a bound that is not promised is null.
Json to_json(const Bound& bound) {
  const auto finite_or_null = [](double x) { return std::isfinite(x) ? Json(x) : Json(); };
  return {{"measured", finite_or_null(bound.measured)},
          {"promised", finite_or_null(bound.promised)},
          {"far_power", bound.far_power},
          {"proven", bound.is_proven}};
}

Json to_json(const Contract& contract) {
  Json holds = Json::array();
  for (std::size_t i = 0; i < claim_count; ++i) {
    const auto claim = static_cast<Claim>(i);
    if (contract.holds.contains(claim)) holds.push_back(claim_name(claim));
  }
  Json refuted = Json::array();
  for (const auto& [claim, because] : contract.refuted)
    if (!because.empty()) refuted.push_back({{"claim", claim_name(claim)}, {"because", because}});
  return {{"verdict", to_json(contract.verdict)},
          {"residual", to_json(contract.residual)},
          {"ulp", to_json(contract.ulp)},
          {"point", to_json(contract.hit.point)},
          {"normal", to_json(contract.hit.normal)},
          {"coordinates", to_json(contract.hit.coordinates)},
          {"domain",
           {{"float32", contract.domain.reach_float},
            {"float64", contract.domain.reach_double},
            {"transformed", contract.domain.reach_transformed},
            {"every_number", contract.domain.every_number}}},
          {"holds", holds},
          {"refuted", refuted}};
}

Json to_json(const Subject& subject) {
  const Source& source = subject.source;
  return {{"method", subject.full_name()},
          {"topic", subject.topic},
          {"name", subject.name},
          {"title", subject.title},
          {"source", {{"author", source.author}, {"title", source.title}, {"year", source.year}}},
          {"standing", standing_name(subject.contract.standing)},
          {"contract", to_json(subject.contract)}};
}

/// "0.62 of 1": worst found of promised; "1" where nothing was found; a dash where nothing is promised. A
/// proven promise has a star.
std::string in_words(const Bound& bound) {
  if (!std::isfinite(bound.promised)) return "-";
  const std::string promise = fmt::format("{:g}{}", bound.promised, bound.is_proven ? "*" : "");
  return std::isfinite(bound.measured) ? fmt::format("{:.3g} of {}", bound.measured, promise) : promise;
}

/// "first hit: point 1.6 of 2, normal 1.1 of 4"; nothing where nothing is promised of it.
std::string in_words(const HitBounds& hit) {
  std::string text;
  for (const auto& [name, bound] : {std::pair{"point", hit.point}, std::pair{"normal", hit.normal},
                                    std::pair{"coordinates", hit.coordinates}})
    if (std::isfinite(bound.promised))
      text += fmt::format("{} {} {}", text.empty() ? "first hit:" : ",", name, in_words(bound));
  return text;
}

/// "2^±28", or "any size" where the reach is beyond every number of the format.
std::string in_words(const Domain& domain) {
  const auto size = [](int reach, int of_smallest_subnormal) {
    return reach > of_smallest_subnormal ? "any size" : fmt::format("2^±{}", reach);
  };
  return fmt::format("domain {} in float32, {} in float64", size(domain.reach_float, 149),
                     size(domain.reach_double, 1074));
}

/// Prints a text under a row, broken between words to lines of 80 letters.
void print_detail(std::string_view text) {
  constexpr std::ptrdiff_t width = 80;
  const auto letters = [](const std::string& line) {  // of UTF-8
    return std::ranges::count_if(line, [](char c) { return (c & 0xC0) != 0x80; });
  };
  std::string line = "   ";
  while (!text.empty()) {
    const std::string word(text.substr(0, text.find(' ')));
    text.remove_prefix(std::min(word.size() + 1, text.size()));
    if (letters(line + word) >= width) {
      fmt::print("{}\n", line);
      line = "   ";
    }
    line += ' ' + word;
  }
  fmt::print("{}\n", line);
}

void print_table() {
  constexpr auto row = "{:<31} {:<8} {:<11} {:<11} {}\n";
  fmt::print(row, "method", "standing", "verdict", "residual", "ulp");
  for (const Subject& subject : subjects()) {
    const Contract& contract = subject.contract;
    const Source& source = subject.source;
    fmt::print(row, subject.full_name(), standing_name(contract.standing), in_words(contract.verdict),
               in_words(contract.residual), in_words(contract.ulp));
    print_detail(fmt::format("{} ({}, {}, {})", subject.title, source.author, source.title, source.year));
    print_detail(
        in_words(contract.domain) +
        (contract.verdict.far_power == 0 ? "" : fmt::format("; far_power {}", contract.verdict.far_power)));
    if (const std::string hit = in_words(contract.hit); !hit.empty()) print_detail(hit);
    for (const auto& [claim, because] : contract.refuted)
      if (!because.empty()) print_detail(fmt::format("breaks {}: {}", claim_name(claim), because));
  }
}

/// The headers that define the units, two a line.
std::string headers() {
  std::string lines, row;
  Topics::for_each([&]<class Topic>(std::type_identity<Topic>) {
    const std::string header = fmt::format("  rayproof/{}.hpp", Topic::name);
    if (header == "  rayproof/point_in_polygon.hpp") return;  // in polygon.hpp
    lines += row.empty() ? "\n" + header : fmt::format("{:{}}{}", "", 32 - row.size(), header);
    row = row.empty() ? header : "";
  });
  return lines;
}

void print_json() {
  Json all = Json::array();
  for (const Subject& subject : subjects()) all.push_back(to_json(subject));
  fmt::print("{}\n", write_json(all, 2));
}

constexpr auto footer =
    R"(The table has a row of bounds for each method, and under it what the method
does, its source, its domain, and which properties of rayproof check it breaks.

  method     SHAPE/METHOD, as other programs take it for --method.
  standing   sound: keeps its bounds. naive: the right formula, but rounding
             breaks it. printed: copied from a publication with its error.
  verdict    A wrong verdict (hit or miss, number of roots, inside or outside)
             is excused in a band around each change of verdict; this is how
             wide the band is.
  residual   How far from the surface a reported hit may lie; of a root, how far
             the equation's left side may be from 0.
  ulp        How far t, or a root, may be from the exact one, in units in the
             last place: distances from one floating-point number to the next.
  domain     The bounds hold while the sizes that enter the formula lie between
             2^-N and 2^N (2^±N); beyond, it may overflow or underflow.
  far_power  Where it is 1, the unit of the verdict's band grows: for a sphere
             or a cylinder, as that of the residual, with the origin's distance
             over the shape's size; for a triangle with 1 over its steepness,
             that is, where it is thin or seen edge-on.
  first hit  Bounds on what is said of it beside t: how far its point may be
             from the ray at t, its normal from the surface's there, in angle,
             and its barycentric coordinates from the exact ones; their units
             stand above HitBounds in rayproof/method/contract.hpp.
  breaks     A property that the method fails, and why; rayproof check must find
             the counterexample.

A bound reads "worst found of promised": the worst that random cases and guided
search (rayproof worst) ever found, which is a lower bound of the worst there
is, and what the tests hold the method to. A star says that the promise is
proven; a dash promises nothing. Verdict and residual are multiples of the unit
roundoff (2^-24 in float32, 2^-53 in float64) times the size of what enters the
formula, so that scaling a scene changes no bound. That unit, and the sizes of
the domain, are defined above each struct in
{}

where polygon.hpp has those of point_in_polygon, too.

In the listing of --json, null is no promise, every_number means that the
domain is asked of all numbers of a case but 0, transformed is its N under a
transform, for methods that take the transform themselves, and holds are the
properties that the method is held to.

Exit status: 0, or 2 for a wrong command line.)";

}  // namespace

int main(int argc, char** argv) {
  CommandLine app("Lists every method: what it does, where it comes from, what it promises.",
                  "rayproof methods");
  bool as_json = false;
  app.add_flag("--json", as_json, "One JSON array with the contract of each method");
  app.footer(fmt::format(footer, headers()));
  if (const auto status = parse_command_line(app, argc, argv)) return *status;

  try {
    if (as_json)
      print_json();
    else
      print_table();
    return 0;
  } catch (const std::system_error&) {  // of the output, which says so at the end of every program
  }
  return 2;
}
