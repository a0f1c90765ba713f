#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>

#include "case/json/number_text.hpp"
#include "case/writer.hpp"
#include "generators/generators.hpp"
#include "properties/numbers.hpp"
#include "unit/generators/seed_hashes.hpp"

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

TEST(TheCasesOfASeed, AreTheSameWhicheverCompilerDrawsThem) {
  std::map<std::string_view, std::uint32_t> recorded;
  for (const SeedHash& one : seed_hashes) recorded[one.family] = one.hash;
  EXPECT_EQ(recorded.size(), families().size());
  for (const Family& family : families()) {
    const std::string name = family.topic + "/" + family.name;
    const std::uint32_t hash = hash_of(family);
    EXPECT_TRUE(recorded.contains(name) && recorded[name] == hash)
        << fmt::format("the line of these cases is\n    {{\"{}\", 0x{:08x}}},", name, hash);
  }
}

}  // namespace
}  // namespace rayproof
