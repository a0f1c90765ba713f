#include "subjects/default_contract.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "subjects/subject.hpp"

namespace rayproof {
namespace {

TEST(DefaultContract, PromisesNoLessRoomThanAnySoundMethodOfOursNeeds) {
  for (const Subject& subject : subjects()) {
    if (subject.contract.standing != Standing::sound) continue;
    const Contract expected = default_contract(subject.topic);
    EXPECT_GE(expected.verdict.promised, subject.contract.verdict.promised) << subject.full_name();
    if (std::isfinite(subject.contract.residual.promised)) {
      EXPECT_GE(expected.residual.promised, subject.contract.residual.promised) << subject.full_name();
    }
    EXPECT_LE(expected.domain.reach_float, subject.contract.domain.reach_float) << subject.full_name();
  }
}

TEST(DefaultContract, IsWhatUsersExpectAndNothingOfOurOwn) {
  for (const std::string& topic : topics()) {
    const Contract expected = default_contract(topic);
    for (const Claim claim :
         {Claim::verdict, Claim::residual, Claim::ascending, Claim::scaled, Claim::answers})
      EXPECT_TRUE(expected.holds.contains(claim)) << topic;
    for (const Claim claim : {Claim::nan, Claim::batch, Claim::bounded, Claim::ulp})
      EXPECT_FALSE(expected.holds.contains(claim)) << topic;
  }
  EXPECT_THROW((void)default_contract("teapot"), std::logic_error);
}

}  // namespace
}  // namespace rayproof
