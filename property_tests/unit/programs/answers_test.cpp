/// \file
/// The programs as somebody outside meets them: what they answer, and how they end.

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "unit/command.hpp"
#include "unit/programs/program_run.hpp"

namespace rayproof {
namespace {

using test::Ended, test::run_program, test::TemporaryFile;
using test::quadratic_answer, test::quadratic_case, test::sphere_answer, test::sphere_case;

TEST(oracle_program, answers_a_file_or_standard_input) {
  const TemporaryFile file(std::string(sphere_case) + "\n" + quadratic_case + "\n");
  const std::string expected = std::string(sphere_answer) + "\n" + quadratic_answer + "\n";
  for (const std::string& command :
       {"oracle " + file.path(), "oracle < " + file.path(), "oracle - < " + file.path()}) {
    const Ended answered = run_program(command);
    EXPECT_EQ(answered.output, expected) << command;
    EXPECT_EQ(answered.status, 0) << command;
  }
}

TEST(oracle_program, ends_with_1_where_a_line_was_refused) {
  const TemporaryFile file("nonsense\n" + std::string(quadratic_case) + "\n");
  const Ended answered = run_program("oracle " + file.path());
  EXPECT_EQ(answered.status, 1);
  EXPECT_NE(answered.output.find("\"line\": 1, \"error\""), std::string::npos);
  EXPECT_NE(answered.output.find(quadratic_answer), std::string::npos);
}

TEST(oracle_program, is_quiet_when_its_reader_has_seen_enough) {
  const TemporaryFile file([] {
    std::string text;
    for (int i = 0; i < 20000; ++i) text += std::string(quadratic_case) + "\n";
    return text;
  }());
  EXPECT_EQ(run_program("oracle " + file.path() + " | head -n 1").output,
            quadratic_answer + std::string("\n"));
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
  const Ended answered = run_program("intersect --method sphere/compensated " + file.path());
  EXPECT_EQ(answered.status, 0);
  EXPECT_EQ(answered.output, std::string(sphere_answer) + "\n");
}

TEST(intersect_program, refuses_a_case_of_another_topic_by_its_field) {
  const TemporaryFile file(std::string(sphere_case) + "\n" + quadratic_case + "\n");
  const Ended sphere = run_program("intersect --method sphere/centred " + file.path());
  EXPECT_EQ(sphere.status, 1);
  EXPECT_NE(sphere.output.find(R"("line": 2, "error": "query is quadratic, which)"), std::string::npos)
      << sphere.output;
  const Ended quadratic = run_program("intersect --method quadratic/kahan " + file.path());
  EXPECT_EQ(quadratic.status, 1);
  EXPECT_NE(quadratic.output.find(R"({"id": 7, "line": 1, "error": "shape.type is sphere, which)"),
            std::string::npos)
      << quadratic.output;
}

TEST(methods_program, lists_every_method_with_its_contract) {
  const nlohmann::json methods = nlohmann::json::parse(run_program("methods --json").output);
  ASSERT_GE(methods.size(), 12U);
  const std::string table = run_program("methods").output;
  for (const nlohmann::json& method : methods) {
    const auto name = method.at("method").get<std::string>();
    EXPECT_NE(table.find(name), std::string::npos) << name;
    EXPECT_FALSE(method.at("title").get<std::string>().empty()) << name;
    EXPECT_GT(method.at("source").at("year"), 1900) << name;
    EXPECT_TRUE(method.at("contract").at("verdict").contains("promised")) << name;
    EXPECT_EQ(method.at("standing") == "sound", method.at("contract").at("refuted").empty()) << name;
  }
}

TEST(replay_program, says_where_there_is_nothing_to_judge) {
  const TemporaryFile empty("");
  const Ended answered = run_program("replay " + empty.path());
  EXPECT_EQ(answered.status, 0);
  EXPECT_NE(answered.output.find(empty.path() + " is empty: it holds no finding and no case to judge\n"),
            std::string::npos)
      << answered.output;
}

TEST(replay_program, takes_no_silence_of_a_program_for_a_right_answer) {
  const TemporaryFile finding(
      R"({"subject": "sphere/command", "command": "cat", "case_seconds": 2, "property": "verdict", "case": )" +
      std::string(sphere_case) + "}\n");
  const Ended answered = run_program("replay " + finding.path());
  EXPECT_EQ(answered.status, 1) << answered.output;
  EXPECT_NE(answered.output.find("gives no answer: "), std::string::npos) << answered.output;
  EXPECT_NE(answered.output.find("0 as declared, 1 otherwise"), std::string::npos) << answered.output;
}

TEST(replay_program, judges_the_other_lines_where_a_program_cannot_be_started) {
  const std::string line =
      R"({"subject": "sphere/command", "command": "/no/such/program", "case_seconds": 2, "property": "verdict", "case": )" +
      std::string(sphere_case) + "}\n";
  const TemporaryFile findings(line + sphere_case + "\n" + line);
  const Ended answered = run_program("replay " + findings.path());
  EXPECT_EQ(answered.status, 1) << answered.output;
  for (const std::string said :
       {"1  gives no answer: ", " claims hold on ", "3  gives no answer: ", ", 2 otherwise, "})
    EXPECT_NE(answered.output.find(said), std::string::npos) << answered.output;
}

TEST(cases_program, begins_at_once_however_many_are_asked_for) {
  const Ended answered = run_program("cases --count 1e12 --shape plane | head -n 300 | tail -n 1");
  EXPECT_EQ(answered.output, run_program("cases --count 300 --shape plane | head -n 300 | tail -n 1").output);
}

}  // namespace
}  // namespace rayproof
