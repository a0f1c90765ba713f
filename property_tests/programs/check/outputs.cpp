#include "programs/check/outputs.hpp"

#include <stdexcept>

#include "properties/report/json.hpp"
#include "properties/report/junit.hpp"
#include "properties/report/page.hpp"
#include "viz/svg.hpp"

namespace rayproof::check {

namespace {

void open(std::ofstream& file, const std::filesystem::path& path) {
  if (path.empty()) return;
  file.open(path);
  if (!file) throw std::runtime_error(path.string() + " cannot be written");
}

}  // namespace

Outputs::Outputs(const Options& options) : folder_(options.out) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) throw std::runtime_error("--out: the folder " + folder_.string() + " cannot be made");
  open(as_found_, folder_ / "as-found.jsonl");
  open(findings_, options.findings);
  open(json_, options.json);
  open(junit_, options.junit);
}

void Outputs::keep_as_found(const Finding& finding) { as_found_ << write_finding(finding) << std::endl; }

void Outputs::write(const Finding& finding) {
  if (findings_.is_open()) findings_ << write_finding(finding) << std::endl;
}

void Outputs::write(const Plan& plan, const RunResult& result, const Summary& summary) {
  if (json_.is_open()) json_ << json_report(plan, result, summary) << std::endl;
  if (junit_.is_open()) junit_ << junit_report(summary, result) << std::flush;
  std::ofstream page_file;
  open(page_file, page());
  page_file << html_page(plan, result, summary, viz::svg_of);
}

}  // namespace rayproof::check
