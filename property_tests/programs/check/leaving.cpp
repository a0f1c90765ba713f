#include "programs/check/leaving.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "case/files.hpp"
#include "command_line/interrupt.hpp"

namespace rayproof::check {

namespace {

/// Hits for each shape and precision: a few seconds for all.
constexpr std::uint64_t hits_to_leave = 1024;

}  // namespace

std::optional<leaving::SearchResult> leave_surfaces(
    const Settings& settings, const std::function<void(const std::string&, double)>& progress) {
  if (!settings.methods.empty() || !settings.properties.empty() || !settings.families.empty())
    return std::nullopt;
  leaving::SearchSettings search{
      .seed = settings.seed, .cases = std::min(settings.cases, hits_to_leave), .jobs = settings.jobs};
  const std::vector<std::string> known = leaving::topics_with_rays();
  for (const std::string& shape : settings.shapes)
    if (std::ranges::find(known, shape) != known.end()) search.shapes.push_back(shape);
  if (!settings.shapes.empty() && search.shapes.empty()) return std::nullopt;
  if (!settings.precisions.empty()) search.precisions = settings.precisions;
  return leaving::search(search, is_interrupted, [&](double, const std::string& what) { progress(what, 1); });
}

bool report_leaving(const Options& options, const leaving::SearchResult& result) {
  const std::filesystem::path file = std::filesystem::path(options.out) / "leaving.jsonl";
  write_file(file, leaving::case_lines(result));
  fmt::print("{}", leaving::text_brief(result));
  const std::vector<std::string> broken = leaving::broken_promises(result);
  for (const std::string& sentence : broken) fmt::print("FAILED: {}\n", sentence);
  fmt::print("more: ./rayproof spawn, docs/leaving-the-surface.md; a case of each that fails: {}\n",
             file.string());
  return broken.empty();
}

}  // namespace rayproof::check
