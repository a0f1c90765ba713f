#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>

#include "case/json/number_text.hpp"
#include "case/writer.hpp"
#include "generators/generators.hpp"
#include "properties/numbers.hpp"

namespace rayproof {
namespace {

/// The case with every number rounded to three digits: what libm makes of a sine's last bit depends on the
/// processor, and is not what a draw's order changes.
Case in_three_digits(Case one) {
  for (const CaseNumber& number : numbers_of(one))
    *number.value = *parse_number(fmt::format("{:.2e}", *number.value));
  return one;
}

/// A hash of a family's first cases in both precisions (FNV-1a: G. Fowler, L. C. Noll, K.-P. Vo, 1991).
std::uint32_t hash_of(const Family& family) {
  std::uint32_t hash = 2166136261U;
  for (const Precision precision : {Precision::float32, Precision::float64})
    for (std::uint64_t seed = 0; seed < 50; ++seed)
      for (const char c : write_case(in_three_digits(family.generate(seed, precision))))
        hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  return hash;
}

/// The recorded hash of each family, by its name: a file for each topic, a line for each family. Where a
/// family is changed on purpose, the test prints its new line; findings and figures of its seeds change too.
std::map<std::string, std::uint32_t> recorded_hashes() {
  std::map<std::string, std::uint32_t> recorded;
  for (const auto& file : std::filesystem::directory_iterator(
           RAYPROOF_SOURCE_DIR "/property_tests/unit/generators/seed_hashes")) {
    std::ifstream lines(file.path());
    std::uint32_t hash = 0;
    for (std::string family; lines >> family >> std::hex >> hash;) recorded[family] = hash;
  }
  return recorded;
}

TEST(TheCasesOfASeed, AreTheSameWhicheverCompilerDrawsThem) {
  auto recorded = recorded_hashes();
  EXPECT_EQ(recorded.size(), families().size());
  for (const Family& family : families()) {
    const std::string name = family.topic + "/" + family.name;
    const std::uint32_t hash = hash_of(family);
    EXPECT_TRUE(recorded.contains(name) && recorded[name] == hash) << fmt::format(
        "the line of these cases in seed_hashes/{}.txt is\n{} 0x{:08x}", family.topic, name, hash);
  }
}

}  // namespace
}  // namespace rayproof
