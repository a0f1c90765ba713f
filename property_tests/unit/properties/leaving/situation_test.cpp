/// \file
/// Which hits are left, and which are left out.

#include "properties/leaving/situation.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "case/reader.hpp"

namespace rayproof::leaving {

namespace {

Departing upwards_from_a_slab(double height) {
  return {.incoming = read_case(fmt::format(
              R"({{"precision":"float64","ray":{{"origin":[0.5,0.5,1],"direction":[0,0,-1]}},)"
              R"("shape":{{"type":"parallelepiped","corner":[0,0,0],"edges":[[1,0,0],[0,1,0],[0,0,{}]]}}}})",
              height)),
          .side = spawn::Side::front,
          .direction = {0, 0, 1}};
}

TEST(LeavingSituation, AParallelepipedWhoseHeightMayHaveTheWrongSignIsLeftOut) {
  for (const double height : {1.0, 1e-9, 1e-14})
    EXPECT_TRUE(situation_of(upwards_from_a_slab(height))) << height;
  for (const double height : {1e-15, 1e-17}) {
    const Departing thin = upwards_from_a_slab(height);
    const Answer answer = plain_method_of("parallelepiped")->answer(thin.incoming);
    EXPECT_GT(std::get<RayAnswer>(answer).hits.count, 0U);
    EXPECT_FALSE(situation_of(thin)) << height;
  }
}

}  // namespace

}  // namespace rayproof::leaving
