#pragma once
/// \file
/// Answers a stream of cases: one line out for each line in, in order, however long the stream.

#include <cstddef>
#include <functional>
#include <string>

#include "case/answer.hpp"
#include "case/case.hpp"

namespace rayproof {

/// Answers a case, from several threads at once. Throws a Refusal for a case that it has no answer for.
using AnswerFunction = std::function<Answer(const Case&)>;

/// Reads cases from file descriptor `input` and writes their answers, and errors for refused lines, to
/// `output`, and counts the refused. Lines are answered by all cores; a line that has arrived is answered
/// without waiting for more. Throws std::system_error where reading or writing fails.
std::size_t answer_stream(int input, int output, const AnswerFunction& answer);

/// The end of the --help of a program that answers a stream of cases.
extern const char* const stream_help;

/// Answers the cases in `file` ("-" for standard input) on standard output. Gives the exit status: 0 where
/// every line was answered, 1 where one was refused, 2 where the file cannot be read, said in one sentence on
/// standard error.
int run_stream_program(const std::string& file, const AnswerFunction& answer);

}  // namespace rayproof
