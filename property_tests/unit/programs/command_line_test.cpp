/// \file
/// The programs as somebody outside meets them: what they print, and how they end.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

#include "unit/command.hpp"

namespace rayproof {
namespace {

using test::Ended;

/// Runs `rayproof-COMMAND`.
Ended run(const std::string& command) {
  return test::run(std::string(RAYPROOF_BIN_DIR) + "/rayproof-" + command);
}

/// A file that is there as long as the object.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& text) { std::ofstream(path_) << text; }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() { std::filesystem::remove(path_); }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_ = testing::TempDir() + "rayproof_case_" + std::to_string(::getpid()) + ".jsonl";
};

constexpr auto quadratic_case = R"({"query": "quadratic", "a": 1, "b": -3, "c": 2})";
constexpr auto sphere_case =
    R"({"id": 7, "precision": "float32", "ray": {"origin": [0,0,-5], "direction": [0,0,1], "t_min": 0, "t_max": "inf"}, )"
    R"("shape": {"type": "sphere", "center": [0,0,0], "radius": 1}, "transform": [[2,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]})";
constexpr auto sphere_answer =
    R"({"id": 7, "verdict": "hit", "contact": "crossing", "hits": [{"t": 4, "t_hex": "0x1p+2"}, {"t": 6, "t_hex": "0x1.8p+2"}], )"
    R"("point": [0, 0, -1], "normal": [0, 0, -1]})";
constexpr auto quadratic_answer =
    R"({"kind": "two", "roots": [{"x": 1, "x_hex": "0x1p+0"}, {"x": 2, "x_hex": "0x1p+1"}]})";

TEST(oracle_program, answers_a_file_or_standard_input) {
  const TemporaryFile file(std::string(sphere_case) + "\n" + quadratic_case + "\n");
  const std::string expected = std::string(sphere_answer) + "\n" + quadratic_answer + "\n";
  for (const std::string& command :
       {"oracle " + file.path(), "oracle < " + file.path(), "oracle - < " + file.path()}) {
    const Ended answered = run(command);
    EXPECT_EQ(answered.output, expected) << command;
    EXPECT_EQ(answered.status, 0) << command;
  }
}

TEST(oracle_program, ends_with_1_where_a_line_was_refused) {
  const TemporaryFile file("nonsense\n" + std::string(quadratic_case) + "\n");
  const Ended answered = run("oracle " + file.path());
  EXPECT_EQ(answered.status, 1);
  EXPECT_NE(answered.output.find("\"line\": 1, \"error\""), std::string::npos);
  EXPECT_NE(answered.output.find(quadratic_answer), std::string::npos);
}

TEST(oracle_program, ends_with_2_and_one_sentence_for_a_wrong_command_line) {
  for (const std::string command :
       {"oracle --exact", "oracle /no/such/file", "oracle a b", "oracle /", "intersect < /dev/null",
        "intersect --method", "methods --xml", "methods sphere"}) {
    const Ended answered = run(command);
    EXPECT_EQ(answered.status, 2) << command;
    EXPECT_EQ(std::count(answered.output.begin(), answered.output.end(), '\n'), 1) << answered.output;
  }
}

TEST(oracle_program, is_quiet_when_its_reader_has_seen_enough) {
  const TemporaryFile file([] {
    std::string text;
    for (int i = 0; i < 20000; ++i) text += std::string(quadratic_case) + "\n";
    return text;
  }());
  EXPECT_EQ(run("oracle " + file.path() + " | head -n 1").output, quadratic_answer + std::string("\n"));
}

TEST(oracle_program, answers_a_partner_who_waits_for_each_answer_on_a_single_core) {
  const TemporaryFile script(R"(
core=$(taskset -cp $$ | sed 's/.*: \([0-9]*\).*/\1/')
coproc taskset -c "$core" "$1"
for i in 1 2 3; do
  echo "$2" >&"${COPROC[1]}"
  read -r -t 10 -u "${COPROC[0]}" answer && echo "$answer"
done
)");
  const Ended answered =
      test::run("bash " + script.path() + " " RAYPROOF_BIN_DIR "/rayproof-oracle '" + quadratic_case + "'");
  const std::string answer = std::string(quadratic_answer) + "\n";
  EXPECT_EQ(answered.output, answer + answer + answer);
}

TEST(intersect_program, answers_in_the_oracles_format) {
  const TemporaryFile file(sphere_case);
  const Ended answered = run("intersect --method sphere/compensated " + file.path());
  EXPECT_EQ(answered.status, 0);
  EXPECT_EQ(answered.output, std::string(sphere_answer) + "\n");
}

TEST(intersect_program, refuses_a_case_of_another_topic_by_its_field) {
  const TemporaryFile file(std::string(sphere_case) + "\n" + quadratic_case + "\n");
  const Ended sphere = run("intersect --method sphere/centred " + file.path());
  EXPECT_EQ(sphere.status, 1);
  EXPECT_NE(sphere.output.find(R"("line": 2, "error": "query is quadratic, which)"), std::string::npos)
      << sphere.output;
  const Ended quadratic = run("intersect --method quadratic/kahan " + file.path());
  EXPECT_EQ(quadratic.status, 1);
  EXPECT_NE(quadratic.output.find(R"({"id": 7, "line": 1, "error": "shape.type is sphere, which)"),
            std::string::npos)
      << quadratic.output;
}

TEST(intersect_program, names_near_methods_for_one_it_does_not_know) {
  const Ended answered = run("intersect --method sphere/centered < /dev/null");
  EXPECT_EQ(answered.status, 2);
  EXPECT_NE(answered.output.find("did you mean sphere/centred"), std::string::npos) << answered.output;
}

TEST(methods_program, lists_every_method_with_its_contract) {
  const nlohmann::json methods = nlohmann::json::parse(run("methods --json").output);
  ASSERT_GE(methods.size(), 12U);
  const std::string table = run("methods").output;
  for (const nlohmann::json& method : methods) {
    const auto name = method.at("method").get<std::string>();
    EXPECT_NE(table.find(name), std::string::npos) << name;
    EXPECT_FALSE(method.at("title").get<std::string>().empty()) << name;
    EXPECT_GT(method.at("source").at("year"), 1900) << name;
    EXPECT_TRUE(method.at("contract").at("verdict").contains("promised")) << name;
    EXPECT_EQ(method.at("standing") == "sound", method.at("contract").at("refuted").empty()) << name;
  }
}

TEST(programs, name_the_option_that_a_misspelt_one_may_be) {
  for (const std::string command :
       {"intersect --methd sphere/centred", "methods --jsn", "replay --fron=x 1"}) {
    const Ended answered = run(command);
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
    const Ended answered = run(command);
    EXPECT_EQ(answered.status, 2) << command;
    EXPECT_NE(answered.output.find(std::string("did you mean ") + meant + "?"), std::string::npos)
        << answered.output;
    EXPECT_EQ(std::count(answered.output.begin(), answered.output.end(), '\n'), 1) << answered.output;
  }
}

TEST(programs, say_of_a_folder_that_cannot_be_made_what_it_is) {
  for (const std::string command : {"report --out /dev/full", "findings --from /tmp --out /dev/full"}) {
    const Ended answered = run(command);
    EXPECT_EQ(answered.status, 2) << command;
    EXPECT_NE(answered.output.find("the folder /dev/full cannot be made: "), std::string::npos)
        << answered.output;
    EXPECT_EQ(std::count(answered.output.begin(), answered.output.end(), '\n'), 1) << answered.output;
  }
}

TEST(replay_program, says_where_there_is_nothing_to_judge) {
  const TemporaryFile empty("");
  const Ended answered = run("replay " + empty.path());
  EXPECT_EQ(answered.status, 0);
  EXPECT_NE(answered.output.find(empty.path() + " is empty: it holds no finding and no case to judge\n"),
            std::string::npos)
      << answered.output;
}

TEST(replay_program, takes_no_silence_of_a_program_for_a_right_answer) {
  const TemporaryFile finding(
      R"({"subject": "sphere/command", "command": "cat", "case_seconds": 2, "property": "verdict", "case": )" +
      std::string(sphere_case) + "}\n");
  const Ended answered = run("replay " + finding.path());
  EXPECT_EQ(answered.status, 1) << answered.output;
  EXPECT_NE(answered.output.find("gives no answer: "), std::string::npos) << answered.output;
  EXPECT_NE(answered.output.find("0 as declared, 1 otherwise"), std::string::npos) << answered.output;
}

TEST(check_program, refuses_one_file_for_two_outputs) {
  const std::string out = testing::TempDir() + "rayproof_one_file",
                    few = "check --method plane/implicit --cases 10 --out " + out;
  for (const std::string& more :
       {" --json " + out + "/f --junit " + out + "/f", " --json " + out + "/index.html",
        " --findings " + out + "/as-found.jsonl", " --junit " + out + "/./findings.jsonl"}) {
    const Ended answered = run(few + more);
    EXPECT_EQ(answered.status, 2) << more;
    EXPECT_NE(answered.output.find(" would write one file, "), std::string::npos) << answered.output;
  }
  EXPECT_EQ(run(few + " --json /dev/null --junit /dev/null --findings " + out + "/findings.jsonl").status, 0);
}

TEST(programs, refuse_one_file_for_two_outputs) {
  const std::string out = testing::TempDir() + "rayproof_two_outputs";
  for (const std::string& command :
       {"spawn --cases 1 --json " + out + ".json --findings " + out + ".json",
        "leak cube --rays 1 --out " + out + " --json " + out + "/index.html",
        "worst --cases 1 --method plane/implicit --out " + out + " --json " + out + "/findings.jsonl"}) {
    const Ended answered = run(command);
    EXPECT_EQ(answered.status, 2) << command;
    EXPECT_NE(answered.output.find(" would write one file, "), std::string::npos) << answered.output;
  }
}

TEST(cases_program, begins_at_once_however_many_are_asked_for) {
  const Ended answered = run("cases --count 1e12 --shape plane | head -n 300 | tail -n 1");
  EXPECT_EQ(answered.output, run("cases --count 300 --shape plane | head -n 300 | tail -n 1").output);
}

TEST(check_program, replays_and_writes_no_report) {
  const TemporaryFile file(sphere_case);
  const Ended answered = run("check --replay " + file.path() + " --json never.json");
  EXPECT_EQ(answered.status, 2);
  EXPECT_NE(answered.output.find("leave --json, --junit and --findings out"), std::string::npos)
      << answered.output;
}

TEST(programs, complain_to_nobody_where_standard_error_is_closed) {
  for (const std::string command : {"oracle /no/such/file", "check --no-such-option", "replay 1 --from /"})
    EXPECT_EQ(run(command + " 2>&-").status, 2) << command;
}

TEST(programs, end_with_2_where_their_output_is_lost) {
  const TemporaryFile file(sphere_case);
  for (const std::string& command :
       {"oracle " + file.path(), std::string("methods"), std::string("methods --json"),
        std::string("cases --count 1"), std::string("cases --count 100"), "replay " + file.path(),
        std::string("check --help")})
    for (const std::string where : {" > /dev/full", " >&-"}) {
      const Ended answered = run(command + where);
      EXPECT_EQ(answered.status, 2) << command << where;
      EXPECT_EQ(std::count(answered.output.begin(), answered.output.end(), '\n'), 1) << answered.output;
    }
}

TEST(programs, refuse_a_folder_in_place_of_a_file) {
  for (const std::string command : {"oracle /", "replay /", "replay 1 --from /", "check --replay /",
                                    "check --corpus / --cases 1 --shape quadratic"}) {
    const Ended answered = run(command);
    EXPECT_EQ(answered.status, 2) << command;
    EXPECT_NE(answered.output.find("/ ca"), std::string::npos) << answered.output;
    EXPECT_EQ(std::count(answered.output.begin(), answered.output.end(), '\n'), 1) << answered.output;
  }
}

TEST(programs, take_no_number_for_another_one) {
  for (const std::string command :
       {"cases --seed -1", "cases --seed 18446744073709551616", "cases --count 0", "spawn --seed -1",
        "spawn --cases -1", "spawn --cases 0", "spawn --jobs 0", "spawn --jobs -1", "check --seed -1",
        "check --case-seconds nan --subject-command cat", "check --subject-command ''"}) {
    const Ended answered = run(command);
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
    const Ended answered = run(command);
    EXPECT_EQ(answered.status, 2) << command;
    EXPECT_NE(answered.output.find(std::string(": ") + name + " is empty"), std::string::npos)
        << command << answered.output;
    EXPECT_EQ(std::count(answered.output.begin(), answered.output.end(), '\n'), 1) << answered.output;
  }
}

TEST(programs, list_their_options) {
  for (const std::string program : {"oracle", "intersect", "methods"}) {
    const Ended help = run(program + " --help");
    EXPECT_EQ(help.status, 0) << program;
    EXPECT_NE(help.output.find("Exit status"), std::string::npos) << program;
  }
}

}  // namespace
}  // namespace rayproof
