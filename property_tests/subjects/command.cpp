#include "subjects/command.hpp"

#include "subjects/default_contract.hpp"
#include "subjects/pool.hpp"
#include "subjects/program/answerer.hpp"

namespace rayproof {

std::vector<Subject> subjects_of_command(const std::string& name, const std::string& command,
                                         std::chrono::milliseconds case_time, const std::atomic<bool>* stop) {
  const auto program = std::make_shared<program::Program>(command, case_time, stop);
  const StartAnswerer start =
      pooled([program] { return std::make_unique<program::ProgramAnswerer>(program); });
  std::vector<Subject> all;
  for (const std::string& topic : topics()) {
    Subject& subject = all.emplace_back();
    subject.topic = topic;
    subject.name = name;
    subject.title = command;
    subject.contract = default_contract(topic);
    subject.has_own_contract = false;
    subject.case_time = case_time;
    subject.start = start;
    subject.why_given_up = [program] { return program->why_given_up(); };
  }
  return all;
}

}  // namespace rayproof
