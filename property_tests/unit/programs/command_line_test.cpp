/// \file
/// What the programs say to a command line that is wrong, and where their output is lost.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "unit/command.hpp"
#include "unit/programs/program_run.hpp"

namespace rayproof {
namespace {

using test::Ended, test::run_program, test::sphere_case, test::TemporaryFile;

TEST(oracle_program, ends_with_2_and_one_sentence_for_a_wrong_command_line) {
  for (const std::string command :
       {"oracle --exact", "oracle /no/such/file", "oracle a b", "oracle /", "intersect < /dev/null",
        "intersect --method", "methods --xml", "methods sphere"}) {
    const Ended answered = run_program(command);
    EXPECT_EQ(answered.status, 2) << command;
    EXPECT_EQ(std::count(answered.output.begin(), answered.output.end(), '\n'), 1) << answered.output;
  }
}

TEST(intersect_program, names_near_methods_for_one_it_does_not_know) {
  const Ended answered = run_program("intersect --method sphere/centered < /dev/null");
  EXPECT_EQ(answered.status, 2);
  EXPECT_NE(answered.output.find("did you mean sphere/centred"), std::string::npos) << answered.output;
}

TEST(programs, name_the_option_that_a_misspelt_one_may_be) {
  for (const std::string command :
       {"intersect --methd sphere/centred", "methods --jsn", "replay --fron=x 1"}) {
    const Ended answered = run_program(command);
    EXPECT_EQ(answered.status, 2) << command;
    EXPECT_NE(answered.output.find("there is no option --"), std::string::npos) << answered.output;
    EXPECT_NE(answered.output.find("; did you mean --"), std::string::npos) << answered.output;
  }
}

TEST(programs, name_what_a_misspelt_name_may_be) {
  for (const auto& [command, meant] : std::initializer_list<std::pair<const char*, const char*>>{
           {"check --shape sfere", "sphere"},
           {"check --method sphere/centered", "sphere/centred"},
           {"check --property verdikt", "verdict"},
           {"check --family bit_paterns", "bit_patterns"},
           {"check --subject vtk-tre", "vtk-tree"},
           {"spawn --shape sfere", "sphere"},
           {"leak --method moller_trumbor", "moller_trumbore"},
           {"leak knott", "knot"},
           {"walk far-sphare", "far-sphere"},
           {"report --shape sfere", "sphere"}}) {
    const Ended answered = run_program(command);
    EXPECT_EQ(answered.status, 2) << command;
    EXPECT_NE(answered.output.find(std::string("did you mean ") + meant + "?"), std::string::npos)
        << answered.output;
    EXPECT_EQ(std::count(answered.output.begin(), answered.output.end(), '\n'), 1) << answered.output;
  }
}

TEST(programs, say_of_a_folder_that_cannot_be_made_what_it_is) {
  for (const std::string command : {"report --out /dev/full", "findings --from /tmp --out /dev/full"}) {
    const Ended answered = run_program(command);
    EXPECT_EQ(answered.status, 2) << command;
    EXPECT_NE(answered.output.find("the folder /dev/full cannot be made: "), std::string::npos)
        << answered.output;
    EXPECT_EQ(std::count(answered.output.begin(), answered.output.end(), '\n'), 1) << answered.output;
  }
}

TEST(docs_program, says_of_an_out_that_is_no_folder_why_no_site_can_be_made_there) {
  if (!std::filesystem::exists(RAYPROOF_BIN_DIR "/rayproof-docs")) GTEST_SKIP() << "no Python";
  const TemporaryFile file("");
  for (const std::string& out : {std::string("/dev/null"), std::string("/proc/x"), file.path()}) {
    const Ended answered = run_program("docs --out " + out);
    if (answered.status == 69) GTEST_SKIP() << answered.output;
    EXPECT_EQ(answered.status, 2) << answered.output;
    EXPECT_NE(answered.output.find("cannot be made in --out " + out + ": "), std::string::npos)
        << answered.output;
    EXPECT_EQ(std::count(answered.output.begin(), answered.output.end(), '\n'), 1) << answered.output;
  }
}

TEST(check_program, refuses_one_file_for_two_outputs) {
  const std::string out = testing::TempDir() + "rayproof_one_file",
                    few = "check --method plane/implicit --cases 10 --out " + out;
  for (const std::string& more :
       {" --json " + out + "/f --junit " + out + "/f", " --json " + out + "/index.html",
        " --findings " + out + "/as-found.jsonl", " --junit " + out + "/./findings.jsonl"}) {
    const Ended answered = run_program(few + more);
    EXPECT_EQ(answered.status, 2) << more;
    EXPECT_NE(answered.output.find(" would write one file, "), std::string::npos) << answered.output;
  }
  EXPECT_EQ(
      run_program(few + " --json /dev/null --junit /dev/null --findings " + out + "/findings.jsonl").status,
      0);
}

TEST(programs, refuse_one_file_for_two_outputs) {
  const std::string out = testing::TempDir() + "rayproof_two_outputs";
  for (const std::string& command :
       {"spawn --cases 1 --json " + out + ".json --findings " + out + ".json",
        "draw 3 --png " + out + " --html " + out,
        "leak cube --rays 1 --out " + out + " --json " + out + "/index.html",
        "worst --cases 1 --method plane/implicit --out " + out + " --json " + out + "/findings.jsonl"}) {
    const Ended answered = run_program(command);
    EXPECT_EQ(answered.status, 2) << command;
    EXPECT_NE(answered.output.find(" would write one file, "), std::string::npos) << answered.output;
  }
}

TEST(check_program, replays_and_writes_no_report) {
  const TemporaryFile file(sphere_case);
  const Ended answered = run_program("check --replay " + file.path() + " --json never.json");
  EXPECT_EQ(answered.status, 2);
  EXPECT_NE(answered.output.find("leave --json, --junit and --findings out"), std::string::npos)
      << answered.output;
}

TEST(programs, complain_to_nobody_where_standard_error_is_closed) {
  for (const std::string command : {"oracle /no/such/file", "check --no-such-option", "replay 1 --from /"})
    EXPECT_EQ(run_program(command + " 2>&-").status, 2) << command;
}

TEST(programs, end_with_2_where_their_output_is_lost) {
  const TemporaryFile file(sphere_case);
  for (const std::string& command :
       {"oracle " + file.path(), std::string("methods"), std::string("methods --json"),
        std::string("cases --count 1"), std::string("cases --count 100"), "replay " + file.path(),
        std::string("check --help")})
    for (const std::string where : {" > /dev/full", " >&-"}) {
      const Ended answered = run_program(command + where);
      EXPECT_EQ(answered.status, 2) << command << where;
      EXPECT_EQ(std::count(answered.output.begin(), answered.output.end(), '\n'), 1) << answered.output;
    }
}

TEST(programs, refuse_a_folder_in_place_of_a_file) {
  for (const std::string command :
       {"oracle /", "replay /", "check --replay /", "check --corpus / --cases 1 --shape quadratic"}) {
    const Ended answered = run_program(command);
    EXPECT_EQ(answered.status, 2) << command;
    EXPECT_NE(answered.output.find("/ ca"), std::string::npos) << answered.output;
    EXPECT_EQ(std::count(answered.output.begin(), answered.output.end(), '\n'), 1) << answered.output;
  }
}

TEST(programs, refuse_a_file_that_never_ends) {
  for (const std::string command : {"replay /dev/zero", "merge /dev/zero --out " RAYPROOF_BIN_DIR}) {
    const Ended answered = run_program(command);
    EXPECT_EQ(answered.status, 2) << command;
    EXPECT_NE(answered.output.find("/dev/zero h"), std::string::npos) << answered.output;
    EXPECT_EQ(std::count(answered.output.begin(), answered.output.end(), '\n'), 1) << answered.output;
  }
}

TEST(programs, take_the_folder_of_a_run_for_its_findings) {
  for (const std::string program : {"replay", "explain", "draw", "walk", "bugreport"}) {
    if (!std::filesystem::exists(RAYPROOF_BIN_DIR "/rayproof-" + program)) continue;
    const Ended answered = run_program(program + " 1 --from /no");
    EXPECT_NE(answered.output.find("there is no finding 1: /no can't be read"), std::string::npos)
        << answered.output;
    const Ended folder = run_program(program + " 1 --from /");
    EXPECT_EQ(folder.status, 2) << program;
    EXPECT_NE(folder.output.find("there is no finding 1: /findings.jsonl can't be read"), std::string::npos)
        << folder.output;
  }
}

TEST(programs, end_with_2_where_nothing_is_left_to_measure_or_to_check) {
  for (const auto& [command, sentence] : std::initializer_list<std::pair<const char*, const char*>>{
           {"report --quick --method sphere/centred --family slivers",
            "--method sphere/centred answers no case of --family slivers: there is nothing to measure"},
           {"report --quick --method centred,stable --family grazing,slivers",
            "--family slivers has no case for --method centred,stable: there is nothing to measure"},
           {"report --quick --scaling threads --method centred", "leave --method out"},
           {"check --method sphere/centred --property ulp", "sphere/centred does not claim ulp"},
           {"check --campaign --method sphere/centred --property ulp", "sphere/centred does not claim ulp"},
           {"check --method sphere/centred --property sure --cases 100",
            "nothing was judged: --property sure"},
           {"check --shape quadratic --property verdict,normal", "no method that is asked for claims normal"},
           {"bench --nope", "--nope"}}) {
    const std::string program(command, 0, std::string(command).find(' '));
    if (!std::filesystem::exists(RAYPROOF_BIN_DIR "/rayproof-" + program)) continue;
    const Ended answered = run_program(command);
    EXPECT_EQ(answered.status, 2) << command;
    EXPECT_NE(answered.output.find(sentence), std::string::npos) << answered.output;
    EXPECT_EQ(std::count(answered.output.begin(), answered.output.end(), '\n'), 1) << answered.output;
  }
}

TEST(report_program, makes_no_folder_for_figures_that_it_cannot_read) {
  if (!std::filesystem::exists(RAYPROOF_BIN_DIR "/rayproof-report")) GTEST_SKIP() << "report is not built";
  const TemporaryFile broken("{");
  const std::string folder = broken.path() + ".report";
  EXPECT_EQ(run_program("report --figures " + broken.path() + " --out " + folder).status, 2);
  EXPECT_FALSE(std::filesystem::exists(folder));
}

TEST(programs, take_no_number_for_another_one) {
  for (const std::string command :
       {"cases --seed -1", "cases --seed 18446744073709551616", "cases --count 0", "spawn --seed -1",
        "spawn --cases -1", "spawn --cases 0", "spawn --jobs 0", "spawn --jobs -1", "check --seed -1",
        "check --case-seconds nan --subject-command cat", "check --subject-command ''"}) {
    const Ended answered = run_program(command);
    EXPECT_EQ(answered.status, 2) << command;
    EXPECT_EQ(std::count(answered.output.begin(), answered.output.end(), '\n'), 1) << answered.output;
  }
}

TEST(programs, name_what_is_given_an_empty_value) {
  for (const auto& [command, name] :
       std::initializer_list<std::pair<const char*, const char*>>{{"check --json ''", "--json"},
                                                                  {"check --replay ''", "--replay"},
                                                                  {"check --out ''", "--out"},
                                                                  {"spawn --findings ''", "--findings"},
                                                                  {"leak ''", "MESH"},
                                                                  {"oracle ''", "FILE"},
                                                                  {"intersect --method ''", "--method"}}) {
    const Ended answered = run_program(command);
    EXPECT_EQ(answered.status, 2) << command;
    EXPECT_NE(answered.output.find(std::string(": ") + name + " is empty"), std::string::npos)
        << command << answered.output;
    EXPECT_EQ(std::count(answered.output.begin(), answered.output.end(), '\n'), 1) << answered.output;
  }
}

TEST(programs, refuse_a_list_in_which_a_name_is_empty) {
  for (const auto& [command, name] : std::initializer_list<std::pair<const char*, const char*>>{
           {"check --shape sphere,,plane", "--shape"},
           {"check --method=centred,", "--method"},
           {"spawn --strategy ,proven", "--strategy"},
           {"cases --list --family far,,grazing", "--family"}}) {
    const Ended answered = run_program(command);
    EXPECT_EQ(answered.status, 2) << command;
    EXPECT_NE(answered.output.find(std::string(": a name in ") + name + " is empty"), std::string::npos)
        << command << answered.output;
    EXPECT_EQ(std::count(answered.output.begin(), answered.output.end(), '\n'), 1) << answered.output;
  }
}

TEST(programs, list_their_options) {
  for (const std::string program : {"oracle", "intersect", "methods"}) {
    const Ended help = run_program(program + " --help");
    EXPECT_EQ(help.status, 0) << program;
    EXPECT_NE(help.output.find("Exit status"), std::string::npos) << program;
  }
}

}  // namespace
}  // namespace rayproof
