/// \file
/// What every method answers to cases, as this very build computes it: for whoever compares builds.
///
///     rayproof-build-answers <cases.jsonl >answers.bin
///     rayproof-build-answers methods
///     rayproof-build-answers rounding
///
/// For each line of standard input and each method of its topic, in the order of the library, a `Record`. The
/// second form lists the methods, one a line: its name, and what it promises whatever the flags. The third
/// says whether this build rounds `as written` or `fused`.

#include <cstdio>
#include <iostream>
#include <rayproof/rounding/check.hpp>
#include <rayproof/topics.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "answering/read.hpp"
#include "builds/record.hpp"
#include "case/shapes.hpp"
#include "subjects/reading.hpp"

namespace {

using namespace rayproof;
using builds::Record;

/// The records of a case that is of the topic; false where it is not.
template <class Topic>
bool answer_topic(const Case& one, const std::string& topic, std::vector<Record>& out) {
  if (topic != Topic::name) return false;
  Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
    out.push_back(in_precision(one.precision, [&]<class T>(T) {
      const auto problem = Reading<Topic>::template problem<T>(one);
      const auto found = Topic::template solve<Method, T>(problem);
      return builds::record_of(Reading<Topic>::template answer<Method, T>(one, found));
    }));
  });
  return true;
}

/// What is promised of a method in every build.
template <class Topic, class Method>
const char* promise() {
  if (Method::contract.verdict.promised == 0) return "exact";
  constexpr bool is_triangle = std::string_view(Topic::name) == "triangle";
  const std::string_view name = Method::name;
  return is_triangle && (name == "woop" || name == "plucker") ? "watertight" : "-";
}

void list_methods() {
  Topics::for_each([]<class Topic>(std::type_identity<Topic>) {
    Topic::Methods::for_each([]<class Method>(std::type_identity<Method>) {
      std::cout << Topic::name << '/' << Method::name << ' ' << promise<Topic, Method>() << '\n';
    });
  });
}

void answer_lines() {
  std::vector<Record> out;
  Case one;
  for (std::string line; std::getline(std::cin, line);) {
    if (line.empty()) continue;
    one.question = {};
    answering::read_line(line, one);
    const std::string topic = topic_of(one);
    out.clear();
    Topics::for_each(
        [&]<class Topic>(std::type_identity<Topic>) { (void)answer_topic<Topic>(one, topic, out); });
    std::fwrite(out.data(), sizeof(Record), out.size(), stdout);
  }
}

}  // namespace

int main(int count, char** arguments) {
  std::ios::sync_with_stdio(false);
  const std::string_view what = count > 1 ? arguments[1] : "";
  if (what == "methods")
    list_methods();
  else if (what == "rounding")
    std::cout << (rounds_as_written() ? "as written\n" : "fused\n");
  else
    answer_lines();
}
