/// \file
/// rayproof intersect: answers cases with a float method.

#include <algorithm>
#include <vector>

#include "case/reader/near_names.hpp"
#include "case/shape_format.hpp"
#include "command_line/command_line.hpp"
#include "programs/stream/answer_stream.hpp"
#include "subjects/subject.hpp"

namespace {

using namespace rayproof;

/// The one sentence about a method that does not exist.
std::string unknown_method(const std::string& name) {
  std::vector<std::string> names;
  for (const Subject& subject : subjects()) names.push_back(subject.full_name());
  return fmt::format(
      "rayproof intersect: there is no method {}; did you mean {}? (rayproof methods lists all)", name,
      fmt::join(near_names(name, names, 3), " or "));
}

/// The subject's answer, or a Refusal where the case is about something else.
Answer answer_with(const Subject& subject, const Case& one) {
  const std::string topic = topic_of(one);
  if (topic == subject.topic) return subject.answer(one);
  const char* const field = std::holds_alternative<RayQuestion>(one.question) ? "shape.type" : "query";
  throw Refusal(
      field, fmt::format("{} is {}, which the method {} does not answer", field, topic, subject.full_name()));
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine app("Answers cases with a float method, in each case's own precision.", "rayproof intersect");
  std::string method;
  std::string file = "-";
  app.add_option("--method", method, "The method, as in sphere/centred; rayproof methods lists all")
      ->required()
      ->type_name("SHAPE/METHOD");
  app.add_option("FILE", file, "The cases; standard input where left out or -");
  app.footer(stream_help);
  if (const auto status = parse_command_line(app, argc, argv)) return *status;

  const Subject* const subject = find_subject(method);
  if (subject == nullptr) {
    print_to_stderr("{}\n", unknown_method(method));
    return 2;
  }
  return run_stream_program(file, [subject](const Case& one) { return answer_with(*subject, one); });
}
