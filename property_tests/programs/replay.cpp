/// \file
/// rayproof replay: judges findings or cases again.

#include "properties/replay.hpp"

#include "case/findings_file.hpp"
#include "command_line/command_line.hpp"
#include "command_line/idle_options.hpp"

int main(int argc, char** argv) {
  rayproof::CommandLine app("Judges a finding of rayproof check again, or all findings and cases of a file.",
                            "rayproof replay");
  std::string what;
  std::string findings = rayproof::last_findings;
  app.add_option("WHAT", what, "The number of a finding, or a file of findings or cases")->required();
  app.add_option("--from", findings, "The findings of the run whose number is given, or its folder")
      ->capture_default_str()
      ->type_name("FILE");
  app.footer("Exit status: 0 all is as the contracts declare, 1 not so, 2 wrong command line.");
  if (const auto status = rayproof::parse_command_line(app, argc, argv)) return *status;
  try {
    const auto number = rayproof::finding_number(what);
    if (!number) rayproof::refuse_options(app, {"--from"}, what + " is not the number of a finding");
    return number ? rayproof::replay_finding(findings, *number) : rayproof::replay_file(what);
  } catch (const std::exception& trouble) {
    rayproof::print_trouble("rayproof replay", trouble);
    return 2;
  }
}
