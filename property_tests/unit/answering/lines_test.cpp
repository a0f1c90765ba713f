#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <thread>

#include "case/reader.hpp"
#include "case/writer.hpp"
#include "generators/generators.hpp"
#include "unit/answering/panel.hpp"

namespace rayproof {
namespace {

TEST(line_of_a_case, is_read_as_the_refusing_reader_reads_it) {
  Case light;
  for (const Family& family : families()) {
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      for (std::uint64_t seed = 0; seed < 50; ++seed) {
        Case one = family.generate(seed, precision);
        one.id = "\"a \\\" b\"";
        const std::string line = write_case(one);
        answering::read_line(line, light);
        EXPECT_EQ(write_case(light), write_case(read_case(line)));
      }
    }
  }
}

TEST(line_of_a_case, may_have_blanks_and_any_order_of_its_fields) {
  Case light;
  const std::string line =
      R"( { "shape" : {"radius":1,"center":["0x1p+1", 0 , 3e0], "type":"sphere"}, "note": "\"{[", "ray":{"direction":[0,0,1],)"
      R"("t_max":"inf","origin":[0,0,0]},"id" :  12 } )";
  answering::read_line(line, light);
  EXPECT_EQ(light.id, "12");
  EXPECT_EQ(std::get<Sphere<double>>(std::get<RayQuestion>(light.question).shape).center,
            glm::dvec3(2, 0, 3));
}

TEST(line_that_is_no_case, is_an_error_and_no_crash) {
  const auto f = [](glm::vec3, glm::vec3, glm::vec3, float) { return true; };
  for (const std::string line :
       {"{", "[", "\"", "{\"id\": 7, \"ray\": 3}", "{\"id\": 7, \"shape\": [[[", "nonsense"})
    EXPECT_NE(answer_of(line, f).find("\"error\": "), std::string::npos) << line;
}

TEST(lines, are_answered_as_soon_as_they_are_there) {
  std::array<int, 2> in{}, out{};
  ASSERT_EQ(pipe(in.data()), 0);
  ASSERT_EQ(pipe(out.data()), 0);
  std::thread worker([&] {
    answering::answer_lines(in[0], out[1],
                            [](std::string_view line, std::string& to) { (to += line) += '\n'; });
  });
  std::array<char, 99> got{};
  for (const std::string_view text : {"one\ntw", "o\nthree\n"}) {
    answering::write_all(in[1], text);
    ASSERT_GT(::read(out[0], got.data(), got.size()), 0);
  }
  EXPECT_EQ(std::string_view(got.data(), 10), "two\nthree\n");
  answering::write_all(in[1], "last");
  close(in[1]);
  EXPECT_EQ(::read(out[0], got.data(), got.size()), 5);
  worker.join();
}

}  // namespace
}  // namespace rayproof
