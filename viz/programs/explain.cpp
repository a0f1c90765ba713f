/// \file
/// rayproof explain: shows step by step where a method loses its digits.

#include "viz/programs/report_case.hpp"

int main(int argc, char** argv) {
  rayproof::CommandLine app(
      "Shows step by step what a method does with a case, and where it loses its digits.",
      "rayproof explain");
  rayproof::viz::CaseOptions options;
  options.add_to(app);
  bool as_json = false;
  app.add_flag("--json", as_json, "One line of JSON in place of text");
  if (const auto status = rayproof::parse_command_line(app, argc, argv)) return *status;

  return rayproof::viz::run_and_report("rayproof explain", [&] {
    const auto report = rayproof::viz::report_case(options);
    if (report.method.empty())
      throw rayproof::viz::WrongCommand("--method is needed: which method is to be explained?");
    fmt::print("{}", as_json ? explain_json(report) + "\n" : explain_text(report));
  });
}
