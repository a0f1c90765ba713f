#pragma once
/// \file
/// What the programs that answer a stream of cases have in common.

#include <string>

#include "programs/stream/answer_stream.hpp"

namespace rayproof {

/// The end of such a program's --help.
extern const char* const stream_help;

/// Answers the cases in `file` ("-" for standard input) on standard output. Gives the exit status: 0 where
/// every line was answered, 1 where one was refused, 2 where the file cannot be read, said in one sentence on
/// standard error.
int run_stream_program(const std::string& file, const Answerer& answer);

}  // namespace rayproof
