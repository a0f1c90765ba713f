/// \file
/// rayproof oracle: answers cases exactly.

#include "oracle/oracle.hpp"

#include "command_line/command_line.hpp"
#include "programs/stream/answer_stream.hpp"

int main(int argc, char** argv) {
  rayproof::CommandLine app("Answers cases exactly: verdict, contact, and every number correctly rounded.",
                            "rayproof oracle");
  std::string file = "-";
  app.add_option("FILE", file, "The cases; standard input where left out or -");
  app.footer(rayproof::stream_help);
  if (const auto status = rayproof::parse_command_line(app, argc, argv)) return *status;
  return rayproof::run_stream_program(file, rayproof::oracle::answer);
}
