#include "programs/stream/answer_stream.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>
#include <thread>
#include <vector>

#include "case/shape_format.hpp"

namespace rayproof {
namespace {

/// A pipe whose ends close themselves.
class Pipe {
 public:
  Pipe() {
    if (::pipe(ends_.data()) != 0) throw std::system_error(errno, std::generic_category());
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    close_writer();
    ::close(ends_[0]);
  }
  [[nodiscard]] int reader() const { return ends_[0]; }
  [[nodiscard]] int writer() const { return ends_[1]; }
  void close_writer() {
    if (ends_[1] >= 0) ::close(ends_[1]);
    ends_[1] = -1;
  }
  void write(std::string_view text) const {
    while (!text.empty()) {
      const ssize_t count = ::write(ends_[1], text.data(), text.size());
      ASSERT_GT(count, 0);
      text.remove_prefix(static_cast<std::size_t>(count));
    }
  }
  /// What is there, waiting for at most five seconds.
  [[nodiscard]] std::string read() const {
    pollfd ready{ends_[0], POLLIN, 0};
    if (::poll(&ready, 1, 5000) <= 0) return "";
    std::string text(1 << 16, '\0');
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(::read(ends_[0], text.data(), text.size()), 0)));
    return text;
  }

 private:
  std::array<int, 2> ends_{};
};

/// Answers a quadratic with its coefficient a as root; a = 13 is one that it does not answer.
Answer give_back_a(const Case& one) {
  const double a = std::get<Quadratic<double>>(one.question).a;
  if (a == 13) throw Refusal("a", "a must not be 13");
  return QuadraticAnswer<double>{RootKind::linear, 1, {a}};
}

struct Answered {
  std::vector<std::string> lines;
  std::size_t refused = 0;
};

Answered answer_all(std::string_view text) {
  Pipe in;
  Pipe out;
  Answered answered;
  std::thread feeder([&] {
    in.write(text);
    in.close_writer();
  });
  std::thread stream([&] {
    answered.refused = answer_stream(in.reader(), out.writer(), give_back_a);
    out.close_writer();
  });
  std::string all;
  for (std::string part = out.read(); !part.empty(); part = out.read()) all += part;
  feeder.join();
  stream.join();
  std::istringstream lines(all);
  for (std::string line; std::getline(lines, line);) answered.lines.push_back(line);
  return answered;
}

std::string question(int a) {
  return R"({"id": )" + std::to_string(a) + R"(, "query": "quadratic", "a": )" + std::to_string(a) +
         R"(, "b": 0, "c": 0})";
}

TEST(stream, answers_line_by_line_in_order) {
  constexpr int count = 20000;
  std::string text;
  for (int i = 100; i < 100 + count; ++i) text += question(i) + (i % 3 == 0 ? "\r\n" : "\n");
  const Answered answered = answer_all(text);
  EXPECT_EQ(answered.refused, 0U);
  ASSERT_EQ(answered.lines.size(), static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const std::string start = "{\"id\": " + std::to_string(i + 100) + ",";
    ASSERT_TRUE(answered.lines[static_cast<std::size_t>(i)].starts_with(start)) << i;
  }
}

TEST(stream, refuses_a_line_by_its_number_and_goes_on) {
  const Answered answered = answer_all(question(1) + "\n\nnonsense\n" + question(13) + "\n" + question(2));
  EXPECT_EQ(answered.refused, 3U);
  ASSERT_EQ(answered.lines.size(), 5U);
  EXPECT_EQ(answered.lines[1],
            R"({"id": null, "line": 2, "error": "the line is not JSON: expected a value at byte 1"})");
  EXPECT_EQ(nlohmann::json::parse(answered.lines[2])["line"], 3);
  EXPECT_EQ(answered.lines[3], R"({"id": 13, "line": 4, "error": "a must not be 13"})");
  EXPECT_EQ(nlohmann::json::parse(answered.lines[4])["id"], 2);
}

TEST(stream, needs_no_newline_at_the_end_and_sees_no_line_after_one) {
  EXPECT_EQ(answer_all("").lines.size(), 0U);
  EXPECT_EQ(answer_all("\n").lines.size(), 1U);
  EXPECT_EQ(answer_all(question(1)).lines.size(), 1U);
  EXPECT_EQ(answer_all(question(1) + "\n").lines.size(), 1U);
  EXPECT_EQ(answer_all(std::string("\0\n\0", 3)).lines.size(), 2U);
}

TEST(stream, counts_lines_across_blocks) {
  std::string text;
  for (int i = 0; i < 30000; ++i) text += i % 10000 == 9999 ? "x\n" : question(1) + "\n";
  const Answered answered = answer_all(text);
  EXPECT_EQ(answered.refused, 3U);
  ASSERT_EQ(answered.lines.size(), 30000U);
  for (const std::size_t line : {9999U, 19999U, 29999U}) {
    EXPECT_EQ(nlohmann::json::parse(answered.lines[line])["line"], line + 1);
  }
}

TEST(stream, takes_a_line_longer_than_any_block) {
  const std::string long_note = question(1).insert(1, R"("note": ")" + std::string(3000000, 'x') + "\", ");
  const Answered answered = answer_all(question(2) + "\n" + long_note + "\n" + question(3) + "\n");
  EXPECT_EQ(answered.refused, 0U);
  EXPECT_EQ(answered.lines.size(), 3U);
}

TEST(stream, answers_a_partner_who_waits_for_each_answer) {
  Pipe in;
  Pipe out;
  std::thread stream([&] { answer_stream(in.reader(), out.writer(), give_back_a); });
  for (int i = 100; i < 110; ++i) {
    in.write(question(i) + "\n");
    EXPECT_EQ(nlohmann::json::parse(out.read(), nullptr, false).value("id", 0), i);
  }
  in.close_writer();
  stream.join();
}

/// More lines than blocks may be in work at once: a block that is done is written though the input is silent.
TEST(stream, answers_a_partner_who_waits_after_several_lines) {
  Pipe in;
  Pipe out;
  std::thread stream([&] { answer_stream(in.reader(), out.writer(), give_back_a); });
  bool is_answered = true;
  for (int round = 1; round <= 300 && is_answered; ++round) {
    const int count = round % 40 + 1;
    for (int i = 0; i < count; ++i) in.write(question(i) + "\n");
    for (std::ptrdiff_t answers = 0; answers < count && is_answered;) {
      const std::string part = out.read();
      answers += std::count(part.begin(), part.end(), '\n');
      is_answered = !part.empty();
    }
  }
  EXPECT_TRUE(is_answered);
  in.close_writer();
  stream.join();
}

TEST(stream, says_so_when_the_input_cannot_be_read_or_the_output_not_written) {
  const int folder = ::open("/", O_RDONLY | O_CLOEXEC);
  EXPECT_THROW(answer_stream(folder, STDOUT_FILENO, give_back_a), std::system_error);
  ::close(folder);

  const int full = ::open("/dev/full", O_WRONLY | O_CLOEXEC);
  Pipe in;
  in.write(question(1) + "\n");
  in.close_writer();
  EXPECT_THROW(answer_stream(in.reader(), full, give_back_a), std::system_error);
  ::close(full);
}

}  // namespace
}  // namespace rayproof
