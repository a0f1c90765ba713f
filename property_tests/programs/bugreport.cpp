/// \file
/// rayproof bugreport: a finding in somebody else's library as a report to its makers.

#include "case/findings_file.hpp"
#include "command_line/command_line.hpp"
#include "dossier/bug_report.hpp"
#include "programs/check/peers.hpp"
#include "subjects/command.hpp"
#include "subjects/subject.hpp"

namespace {

using namespace rayproof;

int run(const std::string& number, const std::string& from) {
  const auto wanted = finding_number(number);
  if (!wanted) throw std::runtime_error(number + " is not the number of a finding");
  dossier::RecordedFinding recorded = dossier::read_recorded(finding_line(from, *wanted), *wanted);
  if (recorded.name == command_name) {
    print_to_stderr(
        "rayproof bugreport: nothing to file: finding {} is of a --subject-command, whose makers you know; "
        "rayproof explain and draw show it\n",
        *wanted);
    return 1;
  }
  if (check::is_no_peer(recorded.name) && find_subject(recorded.shape + "/" + recorded.name) != nullptr) {
    print_to_stderr(
        "rayproof bugreport: nothing to file: finding {} is of this library's own method {}/{}, not of "
        "somebody else's library; rayproof explain and draw show it\n",
        *wanted, recorded.shape, recorded.name);
    return 1;
  }
  const std::vector<check::Peer> peers = check::peers_called({recorded.name});
  const dossier::Dossier opened = dossier::open_dossier(std::move(recorded), peers.front().command);
  if (!opened.objection.empty()) {
    print_to_stderr("rayproof bugreport: nothing to file: {}\n", opened.objection);
    return 1;
  }
  fmt::print("{}", dossier::bug_report(opened));
  print_to_stderr("to be filed at {}\n", opened.library.tracker);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  rayproof::CommandLine app(
      "Writes a finding of rayproof check --subject as a report to the makers of the library, in Markdown.",
      "rayproof bugreport");
  std::string number;
  std::string from = rayproof::last_findings;
  app.add_option("N", number, "The number of the finding")->required();
  app.add_option("--from", from, "The findings of the run, or its folder")
      ->capture_default_str()
      ->type_name("FILE");
  app.footer(
      "The library is asked again, and what is right is computed anew, by hand's formula in exact "
      "fractions.\n"
      "Exit status: 0 the report is printed, 1 there is nothing to file, 2 wrong command line.");
  if (const auto status = rayproof::parse_command_line(app, argc, argv)) return *status;
  try {
    return run(number, from);
  } catch (const std::exception& trouble) {
    print_trouble("rayproof bugreport", trouble);
    return 2;
  }
}
