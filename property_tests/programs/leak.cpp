/// \file
/// rayproof leak: rays at a closed mesh's own vertices and edges, and the methods that lose them.

#include <algorithm>

#include "case/files.hpp"
#include "case/one_file.hpp"
#include "command_line/command_line.hpp"
#include "command_line/idle_options.hpp"
#include "command_line/interrupt.hpp"
#include "command_line/progress_line.hpp"
#include "leaks/text.hpp"
#include "programs/leak/subjects.hpp"

namespace {

using namespace rayproof;

leaks::ClosedMesh mesh_called(const std::string& name) {
  const auto& made = leaks::made_meshes();
  const bool is_made = std::find(made.begin(), made.end(), name) != made.end();
  return is_made ? leaks::make_mesh(name) : leaks::read_mesh(name);
}

const char* verdict_on(const leaks::SubjectPanel& panel, bool is_tight, bool was_interrupted) {
  if (!is_tight)
    return panel.guests.empty() ? "NOT every sound method is tight" : "NOT everybody on trial is tight";
  if (was_interrupted) return "nobody who should be tight leaks or hits twice in what was judged";
  return panel.guests.empty() ? "no sound method leaks or hits twice" : "nobody on trial leaks or hits twice";
}

int run(const leaks::LeakOptions& options) {
  const leaks::ClosedMesh mesh = mesh_called(options.mesh);
  const leaks::SubjectPanel panel = leaks::panel_of(options);
  const std::filesystem::path out(options.out);
  for (const char* const own : {"index.html", "cases.jsonl"})
    refuse_one_file("--json", options.json, "--out", out / own);
  make_folder(out);
  expect_writable(options.json);
  keep_on_interrupt();
  ProgressLine progress;
  const leaks::Result result =
      leaks::search(mesh, panel.all, options.settings, is_interrupted,
                    [&](double done, const std::string& what) { progress.show(done, what); });
  progress.clear();
  write_file(out / "index.html", leaks::html_page(mesh, options.settings, result));
  write_file(out / "cases.jsonl", leaks::case_lines(result));
  if (!options.json.empty()) write_file(options.json, leaks::json_text(mesh, options.settings, result));
  fmt::print("{}: {} triangles, closed; seed {}, {} rays for each precision\n\n{}\n", mesh.name,
             mesh.triangles.size(), options.settings.seed, options.settings.rays, leaks::text_table(result));
  const std::vector<std::string> broken = leaks::broken_promises(result);
  for (const std::string& sentence : broken) fmt::print("{}\n", sentence);
  fmt::print("page: {}\n", (out / "index.html").string());
  if (result.was_interrupted) fmt::print("interrupted: only what is shown was judged\n");
  const auto was_asked = [](const leaks::Outcomes& one) {
    return one.total(one.rays) + one.failed + one.unsupported > 0;
  };
  if (!result.was_interrupted && std::ranges::none_of(result.outcomes, was_asked))
    throw std::runtime_error(
        "no ray was judged: the surface turns away from each of them near its target; "
        "more --rays may find some");
  fmt::print("{}\n", verdict_on(panel, broken.empty(), result.was_interrupted));
  return result.was_interrupted ? 130 : broken.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine app(
      "Asks methods of triangles, and other people's programs, about rays at a closed mesh's own vertices "
      "and edges.",
      "rayproof leak");
  leaks::LeakOptions options;
  leaks::describe(app, options);
  if (const auto status = parse_command_line(app, argc, argv)) return *status;
  try {
    if (!options.has_guests())
      refuse_options(app, {"--case-seconds"}, "no --subject-command and no --subject is to be waited for");
    return run(options);
  } catch (const std::exception& trouble) {
    print_trouble("rayproof leak", trouble);
  }
  return 2;
}
