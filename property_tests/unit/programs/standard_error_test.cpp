/// \file
/// Where standard error cannot be written, its words are lost and nothing else is.

#include <gtest/gtest.h>

#include <filesystem>

#include "unit/programs/program_run.hpp"

namespace rayproof {
namespace {

using test::run_program, test::TemporaryFile;

TEST(StandardErrorOnAFullDisk, ChangesNoExitStatusOfACommandThatIsWrong) {
  for (const std::string command :
       {"check --no-such-option", "check --method nobody", "cases --count 0", "spawn --shape cube",
        "leak nowhere.off", "merge nowhere --out nowhere", "worst --method nobody", "replay 1 --from /",
        "oracle /no/such/file", "intersect --method nobody", "findings --from /nowhere --out /dev/full",
        "bugreport one", "explain /no/such/file", "draw /no/such/file --svg a", "walk nothing",
        "report --shape cube", "render /no/such/scene --out a.png"}) {
    const std::string program = command.substr(0, command.find(' '));
    if (!std::filesystem::exists(std::string(RAYPROOF_BIN_DIR) + "/rayproof-" + program)) continue;
    EXPECT_EQ(run_program(command + " 2>/dev/full").status, 2) << command;
    EXPECT_EQ(run_program(command + " 2>/dev/full").output, "") << command;
  }
}

TEST(StandardErrorOnAFullDisk, LeavesWhatIsPrintedOnStandardOutputAsItIs) {
  const TemporaryFile file("nonsense\n");
  const test::Ended lost = run_program("replay " + file.path() + " 2>/dev/full");
  EXPECT_EQ(lost.status, 1);
  EXPECT_EQ(lost.output, "0 as declared, 0 otherwise, 1 lines refused\n");
}

TEST(StandardErrorOnAFullDisk, LeavesTheFrontDoorsExitStatusAsItIs) {
  for (const std::string door : {"/rayproof", "/cmake/front-door.sh"})
    EXPECT_EQ(test::run(RAYPROOF_SOURCE_DIR + door + " no-such-subcommand 2>/dev/full").status, 2) << door;
}

}  // namespace
}  // namespace rayproof
