#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <vector>

#include "unit/viz/programs/programs.hpp"
#include "viz/walkthrough/lesson.hpp"

namespace rayproof::viz {
namespace {

TEST_F(Programs, ExplainNamesTheSubtractionThatLosesPrecision) {
  const Ended ended = run(explain + cancelling + "--method quadratic/textbook");
  EXPECT_EQ(ended.status, 0) << ended.output;
  EXPECT_NE(ended.output.find("In step 'Apply the quadratic formula' the subtraction −b + √D loses 16 of 24 "
                              "bits by cancellation"),
            std::string::npos)
      << ended.output;
}

TEST_F(Programs, ExplainTakesAFileAFindingAndStandardInput) {
  const std::string finding =
      R"({"subject": "sphere/textbook", "property": "robust", "case": {"ray": {"origin": [0,0,-5], )"
      R"("direction": [0,0,1]}, "shape": {"type": "sphere", "center": [0,0,0], "radius": 1}}})";
  std::ofstream(file("findings.jsonl")) << "\n" << finding << "\n" << finding << "\n";
  for (const std::string& command :
       {explain + file("findings.jsonl"), explain + file("findings.jsonl") + " --line 2",
        explain + file("findings.jsonl") + " --line 3",
        "cat " + file("findings.jsonl") + " | " + explain + "-"}) {
    const Ended ended = run(command);
    EXPECT_EQ(ended.status, 0) << ended.output;
    EXPECT_EQ(ended.output.find("sphere/textbook"), 0U) << ended.output;
  }
}

TEST_F(Programs, ABlankLineAndOneBeyondTheLastAreNoCases) {
  std::ofstream(file("cases.jsonl")) << "\n" << a_sphere.substr(1, a_sphere.size() - 3) << "\n";
  const std::string asked = explain + file("cases.jsonl") + " --method sphere/textbook --line ";
  EXPECT_EQ(run(asked + "1").output, "rayproof explain: line 1 of " + file("cases.jsonl") + " is blank\n");
  EXPECT_EQ(run(asked + "2").status, 0);
  EXPECT_EQ(run(asked + "3").output, "rayproof explain: " + file("cases.jsonl") + " has no line 3, only 2\n");
}

TEST_F(Programs, ARefusedCaseEndsWith1AndOneSentenceNamingTheField) {
  const Ended ended =
      run(explain + R"('{"query":"quadratic","a":1,"b":"nan","c":1}' --method quadratic/textbook)");
  EXPECT_EQ(ended.status, 1);
  EXPECT_EQ(ended.output.find("rayproof explain: b "), 0U) << ended.output;
}

TEST_F(Programs, AWrongCommandLineEndsWith2AndOneSentence) {
  for (const std::string& command :
       {explain + cancelling, explain + cancelling + "--method quadratic/textbok",
        explain + cancelling + "--method sphere/centred",
        explain + "no-such-file --method quadratic/textbook",
        explain + cancelling + "--method quadratic/textbook --precision float16", draw + cancelling,
        draw + cancelling + "--svg /no/such/folder/a.svg",
        draw + cancelling + "--png /no/such/folder/a.png"}) {
    const Ended ended = run(command);
    EXPECT_EQ(ended.status, 2) << command << "\n" << ended.output;
    EXPECT_EQ(std::count(ended.output.begin(), ended.output.end(), '\n'), 1) << ended.output;
  }
}

TEST_F(Programs, AFileNamedAsOneOfAnotherKindIsRefused) {
  for (const auto& [command, sentence] : std::initializer_list<std::pair<std::string, const char*>>{
           {draw + cancelling + "--svg x.txt", "rayproof draw: --svg x.txt must end in .svg\n"},
           {draw + cancelling + "--png x.jpg", "rayproof draw: --png x.jpg must end in .png\n"},
           {draw + cancelling + "--heat x.svg", "rayproof draw: --heat x.svg must end in .png\n"},
           {draw + cancelling + "--html x.htm", "rayproof draw: --html x.htm must end in .html\n"},
#ifdef RAYPROOF_HAS_VTK
           {walk_program + "ray --png a.png",
            "rayproof walk: --png writes a picture for each step into a folder"},
#endif
           {walk_program + "spheres --html a.html", "rayproof walk: --html a.html is one page, for "}}) {
    const Ended ended = run("cd " + folder.string() + " && " + command);
    EXPECT_EQ(ended.status, 2) << command;
    EXPECT_EQ(ended.output.find(sentence), 0U) << ended.output;
    EXPECT_TRUE(std::filesystem::is_empty(folder)) << command;
  }
  EXPECT_EQ(run(draw + cancelling + "--svg /dev/null").status, 0);
}

TEST_F(Programs, DrawWritesAPageAndAnSvg) {
  const Ended ended = run(draw + cancelling + "--method quadratic/textbook --svg " + file("a.svg") +
                          " --html " + file("a.html"));
  EXPECT_EQ(ended.status, 0) << ended.output;
  EXPECT_GT(std::filesystem::file_size(file("a.svg")), 1000U);
  EXPECT_GT(std::filesystem::file_size(file("a.html")), 5000U);
}

TEST_F(Programs, ExplainDrawAndWalkTakeTheNumberOfAFinding) {
  const std::string in_folder =
      "cd " + folder.string() + " && env -u DISPLAY " + RAYPROOF_BIN_DIR + "/rayproof-";
  const Ended checked = run(in_folder + "check --cases 3000 --method printed_2ac --precision float32");
  ASSERT_EQ(checked.status, 0) << checked.output;
  const Ended explained = run(in_folder + "explain 1");
  EXPECT_EQ(explained.output.find("sphere/printed_2ac"), 0U) << explained.output;
  const Ended drawn = run(in_folder + "draw 1");
  EXPECT_EQ(drawn.output, "out/check/draw-1.html\n");
  EXPECT_GT(std::filesystem::file_size(file("out/check/draw-1.html")), 5000U);
  const Ended walked = run(in_folder + "walk 1");
  EXPECT_NE(walked.output.find("out/check/walk-1.html\n"), std::string::npos) << walked.output;
  EXPECT_GT(std::filesystem::file_size(file("out/check/walk-1.html")), 10000U);
  for (const std::string program : {"explain", "draw", "walk"}) {
    EXPECT_EQ(run(in_folder + program + " 1 --from other.jsonl").status, 2) << program;
    EXPECT_EQ(run(in_folder + program + " 99").status, 2) << program;
  }
#ifdef RAYPROOF_HAS_VTK
  const Ended slides = run(in_folder + "walk --case out/check/findings.jsonl --png slides");
  EXPECT_EQ(slides.status, 0) << slides.output;
  EXPECT_GT(std::filesystem::file_size(file("slides/sphere-printed_2ac-1.png")), 10000U);
#endif
}

bool says(const Ended& ended, const std::string& words) {
  return ended.output.find(words) != std::string::npos;
}

TEST_F(Programs, AnOutputThatIsLostEndsWith2AndOneSentence) {
  for (const std::string& command : {explain + a_sphere + "--method sphere/textbook", walk_program + "--list",
                                     walk_program + "ray --json"})
    for (const std::string where : {" > /dev/full", " >&-"}) {
      const Ended ended = run(command + where);
      EXPECT_EQ(ended.status, 2) << command << where;
      EXPECT_EQ(std::count(ended.output.begin(), ended.output.end(), '\n'), 1) << ended.output;
    }
}

TEST_F(Programs, ExplainDrawAndWalkShowTheCaseThatAProgramDidNotAnswer) {
  std::ofstream(file("f.jsonl"))
      << R"({"subject": "sphere/command", "shape": "sphere", "method": "command", "property": "answers", )"
      << R"("kind": "protocol", "case": {"ray": {"origin": [0,0,-5], "direction": [0,0,1]}, )"
      << R"("shape": {"type": "sphere", "center": [0,0,0], "radius": 1}}, "got": {"error": "was silent"}, )"
      << R"("command": "false", "case_seconds": 1})"
      << "\n";
  const Ended explained = run(explain + "1 --from " + file("f.jsonl"));
  EXPECT_EQ(explained.status, 0) << explained.output;
  EXPECT_TRUE(says(explained, "exact                     hit: t₀ = 4, t₁ = 6\n")) << explained.output;
  EXPECT_TRUE(says(explained, ": the exact answer alone\n")) << explained.output;
  EXPECT_TRUE(says(explained, "sphere/command gives no answer")) << explained.output;
  const Ended drawn = run(draw + "1 --from " + file("f.jsonl"));
  EXPECT_EQ(drawn.status, 0) << drawn.output;
  EXPECT_TRUE(says(drawn, ": the exact answer alone\n")) << drawn.output;
  EXPECT_TRUE(std::filesystem::exists(file("draw-1.html")));
  const Ended walked = run(walk_program + "1 --from " + file("f.jsonl"));
  EXPECT_EQ(walked.status, 0) << walked.output;
  EXPECT_TRUE(std::filesystem::exists(file("walk-1.html")));
}

TEST_F(Programs, OnlyMethodsWithStepsToShowAreRecommended) {
  for (const std::string& program : {explain + a_sphere, walk_program + "--json --case " + a_sphere}) {
    const Ended ended = run(program + "--method sphere/gln");
    EXPECT_EQ(ended.status, 2) << ended.output;
    EXPECT_TRUE(says(ended, "there is no method sphere/gln; did you mean sphere/")) << ended.output;
    EXPECT_FALSE(says(ended, "sphere/glm")) << ended.output;
    const Ended other = run(program + "--method box/glm");
    EXPECT_TRUE(says(other, "box/glm")) << other.output;
    EXPECT_FALSE(says(other, "sphere/glm")) << other.output;
  }
}

TEST_F(Programs, EveryRecommendedMethodHasStepsToShow) {
  const Ended ended = run(explain + a_sphere + "--method sphere/gl");
  std::istringstream words(ended.output.substr(ended.output.find("did you mean")));
  int recommended = 0;
  for (std::string word; words >> word;) {
    if (!word.starts_with("sphere/")) continue;
    if (word.ends_with('?')) word.pop_back();
    ++recommended;
    const Ended explained = run(explain + a_sphere + "--method " + word);
    EXPECT_EQ(explained.status, 0) << explained.output;
    EXPECT_TRUE(says(explained, "\n1. ")) << explained.output;
  }
  EXPECT_EQ(recommended, 3) << ended.output;
}

TEST_F(Programs, AMethodWithoutStepsAnswersAndNamesSomeThatHaveSteps) {
  const Ended ended = run(explain + a_sphere + "--method sphere/glm");
  EXPECT_EQ(ended.status, 0) << ended.output;
  EXPECT_TRUE(
      says(ended,
           "sphere/glm can't be recorded step by step; its answer is the exact one, correctly rounded. "
           "Methods that can be: sphere/"))
      << ended.output;
}

TEST_F(Programs, WalkListsAllGroupsAndTopicsThatItTakes) {
  const Ended ended = run(walk_program + "--list");
  EXPECT_EQ(ended.status, 0) << ended.output;
  std::set<std::string> listed;
  std::istringstream lines(ended.output);
  for (std::string line; std::getline(lines, line);) {
    std::string name;
    std::istringstream(line) >> name;
    listed.insert(name);
    EXPECT_FALSE(lessons_of(name).empty()) << line;
  }
  EXPECT_TRUE(listed.contains("all")) << ended.output;
  for (const Lesson& lesson : lessons()) {
    EXPECT_TRUE(listed.contains(lesson.group)) << lesson.group;
    EXPECT_TRUE(listed.contains(lesson.name)) << lesson.name;
  }
}

TEST_F(Programs, WalkTakesASoundMethodWhereACaseBringsNoneAndNamesIt) {
  const Ended ended = run(walk_program + "--json --case " + cancelling);
  EXPECT_EQ(ended.status, 0) << ended.output;
  EXPECT_TRUE(says(ended, R"("method":"quadratic/citardauq_viete")")) << ended.output.substr(0, 300);
  EXPECT_TRUE(says(ended, R"("title":"quadratic/citardauq_viete: )")) << ended.output.substr(0, 300);
  const Ended named = run(walk_program + "--html " + file("case.html") + " --case " + cancelling);
  EXPECT_EQ(named.output,
            "rayproof walk: quadratic/citardauq_viete (the first sound method whose steps can be recorded; "
            "--method chooses)\n");
  const Ended chosen =
      run(walk_program + "--html " + file("case.html") + " --method quadratic/kahan --case " + cancelling);
  EXPECT_EQ(chosen.output, "");
}

TEST_F(Programs, WalkRefusesAMethodForATopic) {
  for (const char* option : {"--method sphere/textbook", "--precision float32", "--line 2"}) {
    const Ended ended = run(walk_program + "sphere --json " + option);
    EXPECT_EQ(ended.status, 2) << ended.output;
    EXPECT_NE(ended.output.find("--case"), std::string::npos) << ended.output;
  }
}

TEST_F(Programs, TheStepsOfACompensatedFormulaLoseNothingThatTheyPutBack) {
  const Ended ended = run(walk_program + "--json transformed");
  EXPECT_EQ(ended.status, 0) << ended.output;
  EXPECT_EQ(ended.output.find("loses 23 of 24 bits by cancellation"), std::string::npos);
}

}  // namespace
}  // namespace rayproof::viz
