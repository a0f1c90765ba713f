#include "programs/check/outputs.hpp"

#include <string_view>

#include "case/files.hpp"
#include "case/one_file.hpp"
#include "properties/report/guest.hpp"
#include "properties/report/report.hpp"
#include "viz/page/page.hpp"

namespace rayproof::check {

static void open(std::ofstream& file, const std::filesystem::path& path) {
  if (!path.empty()) file = opened(path);
}

/// Findings may be asked for where they go anyway.
static void refuse_one_file_for_two(const Options& options, const std::filesystem::path& folder) {
  refuse_one_file("--json", options.json, "--junit", options.junit);
  refuse_one_file("--json", options.json, "--findings", options.findings);
  refuse_one_file("--junit", options.junit, "--findings", options.findings);
  for (const char* const own : {"index.html", "scene.js", "as-found.jsonl", "findings.jsonl", "leaving.jsonl",
                                "judged.jsonl", "campaign.json"}) {
    refuse_one_file("--json", options.json, "--out", folder / own);
    refuse_one_file("--junit", options.junit, "--out", folder / own);
    if (own != std::string_view("findings.jsonl"))
      refuse_one_file("--findings", options.findings, "--out", folder / own);
  }
}

Outputs::Outputs(const Options& options) : folder_(options.out) {
  refuse_one_file_for_two(options, folder_);
  make_folder(folder_);
  as_found_ = opened(folder_ / "as-found.jsonl");
  findings_ = opened(folder_ / "findings.jsonl");
  if (std::filesystem::path(options.findings).lexically_normal() !=
      folder_.lexically_normal() / "findings.jsonl")
    open(asked_findings_, options.findings);
  asked_path_ = options.findings;
  json_path_ = options.json;
  junit_path_ = options.junit;
  for (const std::string& file : {json_path_, junit_path_}) expect_writable(file);
}

void Outputs::keep_as_found(const Finding& finding) { as_found_ << write_finding(finding) << std::endl; }

void Outputs::write(const Finding& finding) {
  const std::string line = write_finding(finding);
  findings_ << line << std::endl;
  if (asked_findings_.is_open()) asked_findings_ << line << std::endl;
}

void Outputs::write(const Plan& plan, const RunResult& result, const Summary& summary) {
  if (!json_path_.empty()) write_file(json_path_, json_report(plan, result, summary) + '\n');
  if (!junit_path_.empty()) write_file(junit_path_, junit_report(summary, result));
  finish(as_found_, folder_ / "as-found.jsonl");
  std::string in_order;
  for (const Finding& finding : result.findings) in_order += write_finding(finding) + "\n";
  findings_.close();
  write_file(folder_ / "findings.jsonl", in_order);
  if (asked_findings_.is_open()) finish(asked_findings_, asked_path_);
  // What was written at once had neither number nor diagnosis; a pipe has been read meanwhile.
  if (asked_findings_.is_open() && std::filesystem::is_regular_file(asked_path_)) {
    asked_findings_.close();
    write_file(asked_path_, in_order);
  }
  if (const std::string judged = json_guests(plan, result); !judged.empty())
    write_file(folder_ / "judged.jsonl", judged);
  write_file(folder_ / "scene.js", viz::shared_script());
  write_file(folder_ / "index.html",
             html_page(plan, result, summary, {folder_, viz::case_figure, viz::scene_style(), "scene.js"}));
}

}  // namespace rayproof::check
