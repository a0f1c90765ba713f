#include <fmt/format.h>

#include <fstream>
#include <rayproof/batch/instruction_set.hpp>
#include <thread>

#include "bench/measuring/measure.hpp"

namespace rayproof::report {

namespace {

/// The processor's name for itself; empty where the system does not say.
std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown processor";
}

}  // namespace

std::string machine_name() {
  return fmt::format("{}, {} cores, batches in {}", processor(), std::thread::hardware_concurrency(),
                     name_of(preferred_instruction_set()));
}

}  // namespace rayproof::report
