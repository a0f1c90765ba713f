#include "dossier/recorded.hpp"

#include <fmt/format.h>

#include "case/json/ordered.hpp"
#include "case/reader.hpp"
#include "oracle/oracle.hpp"
#include "properties/report/findings.hpp"
#include "subjects/program/reply.hpp"

namespace rayproof::dossier {
namespace {

using Json = nlohmann::ordered_json;

/// What was answered; where nothing was, the evidence says so.
void read_got(const Json& line, Finding& finding) {
  const Json& got = line.at("got");
  if (got.contains("error")) {
    finding.evidence.no_answer = got.at("error").get<std::string>();
    return;
  }
  const std::string text = write_json(got);
  Outcome outcome = program::ReplyLine(text).outcome(finding.one);
  if (!outcome.is_answered()) throw std::runtime_error(outcome.sentence);
  finding.evidence.got = std::move(outcome.answer);
  // An error is counted of a right verdict alone: who gives fewer hits then gives the nearest.
  auto* hits = std::get_if<RayAnswer>(&finding.evidence.got);
  const bool is_verdict_right = line.contains("error_ulp") && line.at("error_ulp").is_number();
  if (hits != nullptr && is_verdict_right)
    hits->nearest_only = hits->hits.count < std::get<RayAnswer>(finding.evidence.exact).hits.count;
}

RecordedFinding recorded(const Json& line, std::size_t number) {
  RecordedFinding read;
  read.shape = line.at("shape").get<std::string>();
  read.name = line.at("method").get<std::string>();
  read.kind = line.at("kind").get<std::string>();
  Finding& finding = read.finding;
  finding.number = number;
  finding.property = find_property(line.at("property").get<std::string>());
  if (finding.property == nullptr) throw std::runtime_error("its property is unknown");
  finding.diagnosis = line.value("diagnosis", "");
  const double cases = line.value("cases", 0.0);
  if (!(0 <= cases && cases < 0x1p63)) throw std::runtime_error("cases must be a number of cases");
  finding.cases = static_cast<std::uint64_t>(cases);
  finding.one = read_case(write_json(line.at("case")));
  finding.evidence.note = finding.one.note;
  finding.evidence.exact = oracle::answer(finding.one);
  finding.evidence.other = finding.one;  // the words are of the answers that stand here
  read_got(line, finding);
  read.says = in_words(finding);
  return read;
}

}  // namespace

RecordedFinding read_recorded(std::string_view line, std::size_t number) {
  try {
    return recorded(read_json(line), number);
  } catch (const Json::exception&) {
    throw std::runtime_error(
        fmt::format("finding {} can't be read: its line is none of rayproof check --subject", number));
  } catch (const std::exception& problem) {
    throw std::runtime_error(fmt::format("finding {} can't be read: {}", number, problem.what()));
  }
}

}  // namespace rayproof::dossier
