#include "properties/replay.hpp"

#include <fmt/format.h>

#include "case/files.hpp"
#include "case/findings_file.hpp"
#include "case/print_to_stderr.hpp"
#include "case/shape_format.hpp"
#include "case/writer.hpp"
#include "properties/engine/plan.hpp"
#include "properties/guests/probe.hpp"
#include "properties/report/findings.hpp"
#include "subjects/command.hpp"

namespace rayproof {

namespace {

/// Counts what was replayed, and whether it went as the contracts declare.
struct Replays {
  unsigned as_declared = 0;
  unsigned otherwise = 0;
  unsigned refused = 0;
};

void judge(const Subject& subject, const Property& property, const Case& one, std::size_t number,
           Replays& replays) {
  Trial trial(subject, one);
  const bool breaks = ruling_of(property, trial) == Ruling::broken;
  const bool declared = is_declared_refuted(subject, property);
  if (!breaks && !trial.outcome().is_answered()) {
    const Outcome& outcome = trial.outcome();
    ++replays.otherwise;
    fmt::print("{}  {} {}  gives no answer: {}\n", number, subject.full_name(), name_of(one.precision),
               outcome.sentence.empty() ? name_of(outcome.kind) : std::string_view(outcome.sentence));
    return;
  }
  ++(breaks == declared ? replays.as_declared : replays.otherwise);
  if (!breaks) {
    fmt::print("{}  {} {}  does not break '{}'\n", number, subject.full_name(), name_of(one.precision),
               property.name);
    return;
  }
  const Evidence evidence = property.show(trial);
  fmt::print("{}    still breaks '{}'{}: {}\n    {}\n",
             text_finding({number, &subject, &property, "", one, evidence, declared}), property.name,
             declared ? " as declared" : "", evidence.note, write_case(one));
}

/// A bare case: every claim of every subject of its topic; says one line only where all hold.
void judge_all(const Case& one, std::size_t number, Replays& replays) {
  unsigned held = 0;
  for (const Subject& subject : subjects()) {
    if (subject.topic != topic_of(one)) continue;
    for (const Property& property : properties()) {
      if (!claims(subject, property)) continue;
      Trial trial(subject, one);
      if (ruling_of(property, trial) == Ruling::broken)
        judge(subject, property, one, number, replays);
      else
        ++held;
    }
  }
  replays.as_declared += held;
  fmt::print("{} claims hold on {}\n", held, write_case(one));
}

/// The program of a finding as a subject of its case's topic; what its answers hold is asked of it again.
std::vector<Subject> guests_of(const Replayed& replayed) {
  const std::string name = replayed.subject.substr(replayed.subject.find('/') + 1);
  std::vector<Subject> all = subjects_of_command(name, replayed.command, replayed.case_time);
  std::erase_if(all, [&](const Subject& one) { return one.full_name() != replayed.subject; });
  static const std::atomic<bool> go_on{false};
  for (Subject& one : all) (void)learn_abilities(one, 0, {replayed.one.precision}, go_on);
  return all;
}

/// Judges what stands on a line, which is refused where it is no finding and no case.
void replay_line(const std::string& file, const std::string& line, std::size_t number, Replays& replays) {
  try {
    const Replayed replayed = read_replayed(line);
    if (replayed.subject.empty()) return judge_all(replayed.one, number, replays);
    std::vector<Subject> guests;
    if (!replayed.command.empty()) guests = guests_of(replayed);
    const Subject* const subject = guests.empty() ? find_subject(replayed.subject) : &guests.front();
    const Property* const property = find_property(replayed.property);
    if (subject == nullptr) throw Refusal("subject", "subject is unknown: " + replayed.subject);
    if (property == nullptr) throw Refusal("property", "property is unknown: " + replayed.property);
    if (subject->topic != topic_of(replayed.one))
      throw Refusal("case", "case is not one of the subject's topic");
    judge(*subject, *property, replayed.one, number, replays);
  } catch (const program::CannotStart& silence) {  // the other lines may be of others
    ++replays.otherwise;
    fmt::print("{}  gives no answer: {}\n", number, silence.what());
  } catch (const Refusal& refusal) {
    print_to_stderr("{}:{}: {}\n", file, number, refusal.what());
    ++replays.refused;
  }
}

/// What came of all lines, and the exit status.
int summed_up(const Replays& replays) {
  fmt::print("{} as declared, {} otherwise, {} lines refused\n", replays.as_declared, replays.otherwise,
             replays.refused);
  return replays.otherwise + replays.refused == 0 ? 0 : 1;
}

}  // namespace

int replay_file(const std::string& file) {
  std::ifstream in = opened_to_read(file);
  Replays replays;
  std::string line;
  std::size_t count = 0;
  while (read_line(in, line, file)) replay_line(file, line, ++count, replays);
  // A run that found nothing leaves such a file, so that this is no error; said it must be.
  if (count == 0) print_to_stderr("{} is empty: it holds no finding and no case to judge\n", file);
  return summed_up(replays);
}

int replay_finding(const std::string& file, std::size_t number) {
  Replays replays;
  replay_line(file, finding_line(file, number), number, replays);
  return summed_up(replays);
}

}  // namespace rayproof
