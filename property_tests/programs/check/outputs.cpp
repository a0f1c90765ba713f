#include "programs/check/outputs.hpp"

#include <stdexcept>

#include "properties/report/guest.hpp"
#include "properties/report/report.hpp"
#include "viz/page/case_figure.hpp"

namespace rayproof::check {

namespace {

/// Writes the file anew; whatever ends the program meanwhile, either the old or the new text stands there.
void replace(const std::filesystem::path& path, const std::string& text) {
  const std::filesystem::path beside = path.string() + ".new";
  std::error_code error;
  if (!(std::ofstream(beside) << text << std::flush)) error = std::make_error_code(std::errc::io_error);
  if (!error) std::filesystem::rename(beside, path, error);
  if (error) throw std::runtime_error(path.string() + " cannot be written");
}

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
  open(findings_, folder_ / "findings.jsonl");
  if (std::filesystem::path(options.findings).lexically_normal() !=
      folder_.lexically_normal() / "findings.jsonl")
    open(asked_findings_, options.findings);
  asked_path_ = options.findings;
  open(json_, options.json);
  open(junit_, options.junit);
}

void Outputs::keep_as_found(const Finding& finding) { as_found_ << write_finding(finding) << std::endl; }

void Outputs::write(const Finding& finding) {
  const std::string line = write_finding(finding);
  findings_ << line << std::endl;
  if (asked_findings_.is_open()) asked_findings_ << line << std::endl;
}

void Outputs::write(const Plan& plan, const RunResult& result, const Summary& summary) {
  if (json_.is_open()) json_ << json_report(plan, result, summary) << std::endl;
  if (junit_.is_open()) junit_ << junit_report(summary, result) << std::flush;
  std::string in_order;
  for (const Finding& finding : result.findings) in_order += write_finding(finding) + "\n";
  findings_.close();
  replace(folder_ / "findings.jsonl", in_order);
  // What was written at once had neither number nor diagnosis; a pipe has been read meanwhile.
  if (asked_findings_.is_open() && std::filesystem::is_regular_file(asked_path_)) {
    asked_findings_.close();
    replace(asked_path_, in_order);
  }
  if (const std::string judged = json_guests(plan, result); !judged.empty())
    replace(folder_ / "judged.jsonl", judged);
  replace(folder_ / "scene.js", viz::shared_script());
  replace(folder_ / "index.html",
          html_page(plan, result, summary, {folder_, viz::case_figure, viz::scene_style(), "scene.js"}));
}

}  // namespace rayproof::check
