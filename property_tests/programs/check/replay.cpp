#include "programs/check/replay.hpp"

#include <fmt/format.h>

#include <fstream>

#include "case/shape_format.hpp"
#include "case/writer.hpp"
#include "properties/finding.hpp"
#include "properties/plan.hpp"

namespace rayproof::check {

namespace {

/// Counts what was replayed, and whether it went as the contracts declare.
struct Tally {
  unsigned as_declared = 0;
  unsigned otherwise = 0;
};

void judge(const Subject& subject, const Property& property, const Case& one, Tally& tally) {
  Trial trial(subject, one);
  const bool breaks = property.rule(trial) == Ruling::broken;
  const bool declared = is_declared_refuted(subject, property);
  ++(breaks == declared ? tally.as_declared : tally.otherwise);
  fmt::print("{} {}: {}{}\n", subject.full_name(), property.name, breaks ? "still breaks" : "does not break",
             declared ? " (declared broken)" : "");
  if (!breaks) return;
  const Evidence evidence = property.show(trial);
  fmt::print("  case  {}\n  got   {}\n  exact {}\n  {}\n", write_case(one), write_answer(one, evidence.got),
             write_answer(one, evidence.exact), evidence.note);
}

/// A bare case: every claim of every subject of its topic; says one line only where all hold.
void judge_all(const Case& one, Tally& tally) {
  unsigned held = 0;
  for (const Subject& subject : subjects()) {
    if (subject.topic != topic_of(one)) continue;
    for (const Property& property : properties()) {
      if (!claims(subject, property)) continue;
      Trial trial(subject, one);
      if (property.rule(trial) == Ruling::broken)
        judge(subject, property, one, tally);
      else
        ++held;
    }
  }
  tally.as_declared += held;
  fmt::print("{} claims hold on {}\n", held, write_case(one));
}

void replay_line(const std::string& line, Tally& tally) {
  const Replayed replayed = read_replayed(line);
  if (replayed.subject.empty()) return judge_all(replayed.one, tally);
  const Subject* const subject = find_subject(replayed.subject);
  const Property* const property = find_property(replayed.property);
  if (subject == nullptr) throw Refusal("subject", "subject is unknown: " + replayed.subject);
  if (property == nullptr) throw Refusal("property", "property is unknown: " + replayed.property);
  if (subject->topic != topic_of(replayed.one))
    throw Refusal("case", "case is not one of the subject's topic");
  judge(*subject, *property, replayed.one, tally);
}

}  // namespace

int replay(const std::string& file) {
  std::ifstream in(file);
  if (!in) {
    fmt::print(stderr, "rayproof check: {} cannot be read\n", file);
    return 2;
  }
  Tally tally;
  unsigned refused = 0;
  std::string line;
  for (unsigned number = 1; std::getline(in, line); ++number) {
    try {
      replay_line(line, tally);
    } catch (const Refusal& refusal) {
      fmt::print(stderr, "{}:{}: {}\n", file, number, refusal.what());
      ++refused;
    }
  }
  fmt::print("{} as declared, {} otherwise, {} lines refused\n", tally.as_declared, tally.otherwise, refused);
  return tally.otherwise + refused == 0 ? 0 : 1;
}

}  // namespace rayproof::check
