/// \file
/// rayproof cases: prints the cases of the families, for whoever judges elsewhere.

#include <algorithm>
#include <cstdint>
#include <stdexcept>

#include "case/writer.hpp"
#include "command_line/command_line.hpp"
#include "command_line/count_option.hpp"
#include "command_line/idle_options.hpp"
#include "command_line/precision_option.hpp"
#include "command_line/run_options.hpp"
#include "properties/engine/hunt.hpp"

namespace {

using namespace rayproof;

struct CasesOptions {
  std::vector<std::string> shapes{}, families{};
  std::vector<Precision> precisions{};
  std::uint64_t count = 100;
  std::uint64_t seed = 2022;
  bool list = false;
};

template <class T>
bool is_wanted(const std::vector<T>& wanted, const T& one) {
  return wanted.empty() || std::ranges::find(wanted, one) != wanted.end();
}

void describe(CLI::App& app, CasesOptions& options) {
  const auto names = [&](auto member) {
    std::vector<std::string> all;
    for (const Family& family : families())
      if (std::ranges::find(all, family.*member) == all.end()) all.push_back(family.*member);
    return all;
  };
  app.add_option("--shape,--topic", options.shapes, "Only cases about this shape")
      ->delimiter(',')
      ->check(CLI::IsMember(names(&Family::topic)));
  app.add_option("--family", options.families, "Only this family")
      ->delimiter(',')
      ->check(CLI::IsMember(names(&Family::name)));
  add_precision_option(app, options.precisions);
  app.add_option("--count", options.count, "Cases of each family and precision")
      ->capture_default_str()
      ->transform(whole_count());
  add_seed_option(app, options.seed, "Where the random cases begin");
  app.add_flag("--list", options.list, "List the families in place of their cases");
  app.footer(
      "One case a line (docs/case-format.md), its id the name of its family and its number. They are the\n"
      "first ones that rayproof check tests with the same seed.\n"
      "Exit status: 0 done, 2 wrong command line.");
}

void print_cases(const Family& family, Precision precision, const CasesOptions& options) {
  const std::uint64_t blocks = (options.count + cases_in_block - 1) / cases_in_block;
  std::uint64_t k = 0;
  const auto print_block = [&](std::uint64_t block_seed) {
    for (std::uint64_t i = 0; i < cases_in_block && k < options.count; ++i, ++k) {
      Case one = family.generate(combine(block_seed, i), precision);
      one.id = fmt::format("\"{}/{}/{}/{}\"", family.topic, family.name, name_of(precision), k);
      fmt::print("{}\n", write_case(one));
    }
  };
  // A few seeds at first: a reader of the first cases need not wait for the seeds of all.
  for (std::uint64_t done = 0, known = 0; done < blocks; done = known) {
    known = std::min(blocks, std::max<std::uint64_t>(256, 16 * done));
    const auto seeds = seeds_of_blocks(family, precision, options.seed, known);
    std::for_each(seeds.begin() + static_cast<std::ptrdiff_t>(done), seeds.end(), print_block);
  }
}

int run(const CasesOptions& options) {
  bool has_any = false;
  for (const Family& family : families()) {
    if (!is_wanted(options.shapes, family.topic) || !is_wanted(options.families, family.name)) continue;
    has_any = true;
    if (options.list) fmt::print("{:<17}{:<17}{}\n", family.topic, family.name, family.description);
    for (const Precision precision : {Precision::float32, Precision::float64})
      if (!options.list && is_wanted(options.precisions, precision)) print_cases(family, precision, options);
  }
  if (!has_any) print_to_stderr("rayproof cases: no such family has cases about such a shape\n");
  return has_any ? 0 : 2;
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine app("Prints the cases of the families that rayproof check tests, one a line.",
                  "rayproof cases");
  CasesOptions options;
  describe(app, options);
  if (const auto status = parse_command_line(app, argc, argv)) return *status;
  try {
    if (options.list) refuse_options(app, {"--count", "--seed", "--precision"}, "--list prints no cases");
    return run(options);
  } catch (const std::exception& trouble) {
    print_trouble("rayproof cases", trouble);
  }
  return 2;
}
