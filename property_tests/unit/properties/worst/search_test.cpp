/// \file
/// The search for the worst cases of methods.

#include "properties/worst/search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "case/reader.hpp"
#include "case/writer.hpp"
#include "subjects/subject.hpp"

namespace rayproof::worst {
namespace {

const std::atomic<bool> no_stop{false};

WorstResult searched(const std::vector<std::string>& methods, std::uint64_t cases, int jobs = 2) {
  WorstSearch what;
  what.plan = {.seed = 7, .cases = cases, .jobs = jobs, .methods = methods};
  what.plan.precisions = {Precision::float32};
  what.compare = true;
  return search(what, no_stop, [](double, const std::string&) {});
}

const WorstRow& row_of(const WorstResult& result, const std::string& error) {
  for (const WorstRow& row : result.rows)
    if (row.error_name() == error) return row;
  throw std::runtime_error("no row " + error);
}

TEST(Search, FindsAWorseErrorOfTThanDrawsDo) {
  const WorstResult result = searched({"sphere/centred"}, 40'000);
  const WorstRow& row = row_of(result, "ulp");
  EXPECT_GT(row.found->error, 10 * *row.drawn);
  EXPECT_TRUE(result.keeps_promises()) << text_exceeded(result);
}

TEST(Search, NeverFindsWorseThanWhatIsProven) {
  const WorstResult result = searched({"triangle/woop", "triangle/rounded", "sphere/centred"}, 6'000);
  EXPECT_TRUE(result.keeps_promises()) << text_exceeded(result);
  for (const WorstRow& row : result.rows)
    if (row.is_proven() && row.found) {
      EXPECT_LE(row.found->error, row.bound().promised) << row.error_name();
    }
}

TEST(Search, NamesABrokenPromiseAlsoWhereOnlyADrawFoundIt) {
  WorstRow row = row_of(searched({"sphere/textbook"}, 6'000), "residual");
  Subject boastful = *row.subject;
  boastful.contract.residual.promised = row.found->error / 2;
  EXPECT_FALSE(exceeds_promise(*row.subject, row.found->one, row.kind));
  EXPECT_TRUE(exceeds_promise(boastful, row.found->one, row.kind));

  row.exceeding = row.found;
  row.found.reset();
  const WorstResult result{.rows = {row}};
  EXPECT_FALSE(result.keeps_promises());
  EXPECT_NE(text_table(result).find("EXCEEDED"), std::string::npos);
  EXPECT_NE(text_exceeded(result).find(write_case(row.exceeding->one)), std::string::npos);
}

TEST(Search, IsTheSameForEveryNumberOfThreads) {
  const std::vector<std::string> methods{"quadratic/kahan", "quadratic/textbook"};
  const WorstResult alone = searched(methods, 6'000, 1), together = searched(methods, 6'000, 3);
  EXPECT_EQ(json_text({}, alone), json_text({}, together));
  EXPECT_EQ(text_table(alone), text_table(together));
}

TEST(Search, LeavesOutMisprintedMethodsUnlessTheyAreNamed) {
  WorstSearch what;
  what.plan = {.cases = 1, .shapes = {"quadratic"}};
  const auto is_misprinted = [](const WorstRow& row) { return row.subject->name == "printed_b_4ac"; };
  const auto ignore = [](double, const std::string&) {};
  EXPECT_TRUE(std::ranges::none_of(search(what, no_stop, ignore).rows, is_misprinted));
  what.plan.methods = {"printed_b_4ac"};
  EXPECT_THROW((void)search({{.shapes = {"cube"}}, {}, false}, no_stop, ignore), UnknownName);
  (void)search(what, no_stop, ignore);
}

TEST(Search, WritesFindingsWhoseCasesHaveTheErrorThatIsReported) {
  const WorstResult result = searched({"cylinder/centred"}, 3'000);
  for (const WorstRow& row : result.rows) {
    const Replayed read = read_replayed(write_finding(finding_of(row, 1)));
    EXPECT_EQ(read.subject, "cylinder/centred");
    EXPECT_EQ(read.property, measure_of(row.kind).name);
    EXPECT_EQ(errors_of(*row.subject, read.one, true).at(row.kind), row.found->error);
  }
}

/// The contracts' figures of what was found are those of the corpus, or of random cases that were worse.
TEST(Search, FoundNothingInTheCorpusThatTheContractsLeaveOut) {
  constexpr double rounded_figure = 1.01;
  unsigned judged = 0;
  for (const auto& file : std::filesystem::directory_iterator(RAYPROOF_SOURCE_DIR "/property_tests/corpus")) {
    std::ifstream lines(file.path());
    for (std::string line; std::getline(lines, line);) {
      if (line.find("from the guided search") == std::string::npos) continue;
      const Case one = read_case(line);
      for (const Subject& subject : subjects()) {
        if (subject.topic != topic_of(one) || !subject.has_own_contract || is_transformed(one)) continue;
        const ErrorList errors = errors_of(subject, one, true);
        for (std::size_t kind = 0; kind < error_measures.size(); ++kind) {
          const Bound& bound = error_measures.at(kind).bound(subject.contract);
          if (!claims(subject, *find_property(error_measures.at(kind).name)) ||
              !std::isfinite(bound.promised))
            continue;
          ++judged;
          EXPECT_LE(errors.at(kind), bound.measured * rounded_figure)
              << subject.full_name() << " " << error_measures.at(kind).name << " " << line;
        }
      }
    }
  }
  EXPECT_GT(judged, 20U);
}

}  // namespace
}  // namespace rayproof::worst
