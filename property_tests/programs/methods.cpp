/// \file
/// rayproof methods: every method, where it comes from and what it promises.

#include <cmath>
#include <nlohmann/json.hpp>

#include "programs/command_line.hpp"
#include "subjects/contract_names.hpp"
#include "subjects/subject.hpp"

namespace {

using Json = nlohmann::ordered_json;
using namespace rayproof;

/// JSON has no infinity: a bound that is not promised is null.
Json to_json(const Bound& bound) {
  const auto finite_or_null = [](double x) { return std::isfinite(x) ? Json(x) : Json(); };
  return {{"measured", finite_or_null(bound.measured)}, {"promised", finite_or_null(bound.promised)}};
}

Json to_json(const Contract& contract) {
  Json holds = Json::array();
  for (std::size_t i = 0; i < claim_count; ++i) {
    const auto claim = static_cast<Claim>(i);
    if (contract.holds.contains(claim)) holds.push_back(claim_name(claim));
  }
  Json refuted = Json::array();
  for (const Refutation& refutation : contract.refuted) {
    if (refutation.because.empty()) continue;
    refuted.push_back({{"claim", claim_name(refutation.claim)}, {"because", refutation.because}});
  }
  return {{"verdict", to_json(contract.verdict)},
          {"residual", to_json(contract.residual)},
          {"ulp", to_json(contract.ulp)},
          {"domain",
           {{"float32", contract.domain.reach_float},
            {"float64", contract.domain.reach_double},
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
          {"far_power", subject.far_power},
          {"contract", to_json(subject.contract)}};
}

/// "0.62 of 1": measured of promised; "1" where it was never measured; a dash where nothing is promised.
std::string in_words(const Bound& bound) {
  if (!std::isfinite(bound.promised)) return "-";
  if (!std::isfinite(bound.measured)) return fmt::format("{:g}", bound.promised);
  return fmt::format("{:.3g} of {:g}", bound.measured, bound.promised);
}

void print_row(const std::string& method, std::string_view standing, const std::string& verdict,
               const std::string& residual, const std::string& ulp, const std::string& title) {
  fmt::print("{:<27} {:<9} {:<15} {:<15} {:<15} {}\n", method, standing, verdict, residual, ulp, title);
}

void print_detail(const std::string& text) { fmt::print("{:4}{}\n", "", text); }

void print_table() {
  print_row("method", "standing", "verdict", "residual", "ulp", "what it does");
  for (const Subject& subject : subjects()) {
    const Contract& contract = subject.contract;
    const Source& source = subject.source;
    print_row(subject.full_name(), standing_name(contract.standing), in_words(contract.verdict),
              in_words(contract.residual), in_words(contract.ulp), subject.title);
    print_detail(fmt::format("{}, {}, {}", source.author, source.title, source.year));
    for (const Refutation& refutation : contract.refuted) {
      if (refutation.because.empty()) continue;
      print_detail(fmt::format("breaks {}: {}", claim_name(refutation.claim), refutation.because));
    }
  }
}

constexpr auto footer =
    R"(The table: each method's standing (sound; naive: the right formula in an arithmetic that cannot bear it;
printed: copied with its source's error) and its error bounds as 'measured of promised'. A verdict may be wrong
only in a band of that width around a change of verdict; every answer satisfies its equation to that residual;
and is within that many ulps of the exact one. The units stand in rayproof/sphere.hpp and
rayproof/quadratic.hpp; a naive method's grow with the far_power of the JSON listing. A bound holds while the
sizes of the input lie within 2^-domain and 2^domain.

Exit status: 0, or 2 for a wrong command line.)";

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Lists every method: what it does, where it comes from, what it promises.",
               "rayproof methods");
  bool as_json = false;
  app.add_flag("--json", as_json, "One JSON array, with all that is known of each method");
  app.footer(footer);
  if (const auto status = parse_command_line(app, argc, argv)) return *status;

  if (!as_json) {
    print_table();
    return 0;
  }
  Json all = Json::array();
  for (const Subject& subject : subjects()) all.push_back(to_json(subject));
  fmt::print("{}\n", all.dump(2));
  return 0;
}
