#pragma once
/// \file
/// Answers a stream of cases: one line out for each line in, in order, however long the stream.

#include <cstddef>
#include <functional>

#include "case/answer.hpp"
#include "case/case.hpp"

namespace rayproof {

/// Answers a case, from several threads at once. Throws a Refusal for a case that it has no answer for.
using Answerer = std::function<Answer(const Case&)>;

/// Reads cases from file descriptor `input` and writes their answers, and errors for refused lines, to
/// `output`, and counts the refused. Lines are answered by all cores; a line that has arrived is answered
/// without waiting for more. Throws std::system_error where reading or writing fails.
std::size_t answer_stream(int input, int output, const Answerer& answer);

}  // namespace rayproof
