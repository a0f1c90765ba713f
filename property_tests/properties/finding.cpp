#include "properties/finding.hpp"

#include <fmt/format.h>

#include <cmath>

#include "case/json/writer.hpp"
#include "case/reader/field.hpp"
#include "case/writer.hpp"
#include "properties/engine/kind.hpp"
#include "subjects/command.hpp"

namespace rayproof {

std::string write_finding(const Finding& finding) {
  Case with_note = finding.one;
  if (!finding.evidence.note.empty()) with_note.note = finding.evidence.note;
  JsonWriter json;
  json.member("subject").string(finding.subject->full_name());
  json.member("shape").string(finding.subject->topic);
  json.member("method").string(finding.subject->name);
  json.member("property").string(finding.property->name);
  json.member("kind").string(name_of(kind_of(finding)));
  if (!finding.diagnosis.empty()) json.member("diagnosis").string(finding.diagnosis);
  if (finding.cases > 0) json.member("cases").value(static_cast<double>(finding.cases));
  json.member("case").raw(write_case(with_note));
  json.member("got");
  if (finding.evidence.no_answer.empty()) {
    json.raw(write_answer(finding.one, finding.evidence.got));
  } else {
    json.open('{').member("error").string(finding.evidence.no_answer);
    json.close('}');
  }
  json.member("exact").raw(write_answer(finding.one, finding.evidence.exact));
  json.member("error_ulp");
  if (finding.evidence.error_ulp) {
    json.value(*finding.evidence.error_ulp);
  } else {
    json.raw("null");
  }
  if (finding.striking) json.member("striking").raw(write_case(*finding.striking));
  if (!finding.subject->has_own_contract) json.member("command").string(finding.subject->title);
  const std::chrono::duration<double> patience = finding.subject->case_time;
  if (finding.subject->name == command_name && finding.subject->case_time != usual_case_time)
    json.member("case_seconds").value(patience.count());
  return json.take();
}

namespace {

/// As --case-seconds has it.
std::chrono::milliseconds read_case_time(const Field& field) {
  const double seconds = read_number(field, Precision::float64);
  if (!(least_case_seconds <= seconds && seconds <= most_case_seconds))
    field.refuse(
        fmt::format("must be a number of seconds from {} to {}", least_case_seconds, most_case_seconds));
  return std::chrono::milliseconds(std::llround(1000 * seconds));
}

}  // namespace

Replayed read_replayed(std::string_view line) {
  const json::Document document = json::parse(line);
  const Field whole{.document = &document};
  ObjectReader reader(whole);
  const auto nested = reader.find("case");
  if (!nested) return {.one = read_case(line)};
  Replayed result;
  result.subject = read_string(reader.need("subject"));
  result.property = read_string(reader.need("property"));
  if (const auto command = reader.find("command")) result.command = read_string(*command);
  if (const auto seconds = reader.find("case_seconds")) result.case_time = read_case_time(*seconds);
  result.one = read_case(nested->node().text);
  return result;
}

}  // namespace rayproof
