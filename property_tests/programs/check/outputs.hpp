#pragma once
/// \file
/// The files that rayproof check writes.

#include <filesystem>
#include <fstream>

#include "programs/check/options.hpp"
#include "properties/report/summary.hpp"

namespace rayproof::check {

/// Tries the files at once, so that a bad name is known before the work; findings are written as they come,
/// so that none is lost when it is cut short. Throws std::runtime_error with one sentence.
class Outputs {
 public:
  explicit Outputs(const Options& options);

  /// Keeps the case as it was found, before anything else is done with it.
  void keep_as_found(const Finding& finding);
  void write(const Finding& finding);
  void write(const Plan& plan, const RunResult& result, const Summary& summary);

 private:
  std::filesystem::path folder_;
  std::ofstream as_found_{};
  std::ofstream findings_{};  ///< as they come; in order, and numbered by their lines, once the run ends
  std::ofstream asked_findings_{};  ///< the same for --findings
  std::filesystem::path asked_path_{};
  std::string json_path_{}, junit_path_{};
};

}  // namespace rayproof::check
