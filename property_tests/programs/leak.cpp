/// \file
/// rayproof leak: rays at a closed mesh's own vertices and edges, and the methods that lose them.

#include <filesystem>
#include <fstream>

#include "command_line/command_line.hpp"
#include "command_line/interrupt.hpp"
#include "command_line/precision_option.hpp"
#include "command_line/progress_line.hpp"
#include "leaks/text.hpp"

namespace {

using namespace rayproof;

struct LeakOptions {
  leaks::LeakSettings settings{};
  std::string mesh = "knot";
  std::vector<std::string> methods{};
  std::string out = "out/leak";
};

constexpr const char* footer =
    "MESH is cube, sphere, torus or knot, or a file in OFF, OBJ, STL or PLY; it must be closed.\n"
    "Writes DIR/index.html, with a picture of each kind of loss, and DIR/cases.jsonl.\n"
    "Exit status: 0 no sound method leaks or hits twice; 1 not so; 2 wrong command line, or a mesh that "
    "cannot be used; 130 interrupted.";

void describe(CLI::App& app, LeakOptions& options) {
  leaks::LeakSettings& settings = options.settings;
  app.add_option("MESH", options.mesh, "The mesh")->capture_default_str();
  app.add_option("--method", options.methods, "Only these methods of triangles: woop, or triangle/woop")
      ->delimiter(',');
  app.add_option("--seed", settings.seed, "Where the random rays begin")->capture_default_str();
  app.add_option("--rays", settings.rays, "Rays for each precision")->capture_default_str();
  app.add_option("--jobs", settings.jobs, "Threads; as many as the machine has where left out")
      ->check(CLI::Range(1, 1024));
  add_precision_option(app, settings.precisions);
  app.add_option("--out", options.out, "Folder for the page and the cases")->capture_default_str();
  app.footer(footer);
}

/// The methods of triangles that are wanted: all but those printed wrongly where none is named.
std::vector<const Subject*> wanted(const std::vector<std::string>& names) {
  std::vector<const Subject*> found;
  for (const Subject& subject : subjects())
    if (names.empty() && subject.topic == "triangle" && subject.contract.standing != Standing::printed)
      found.push_back(&subject);
  for (const std::string& name : names) {
    const Subject* subject = find_subject(name.starts_with("triangle/") ? name : "triangle/" + name);
    if (subject == nullptr) throw std::runtime_error("there is no method \"" + name + "\" of triangles");
    found.push_back(subject);
  }
  return found;
}

leaks::ClosedMesh mesh_called(const std::string& name) {
  const auto& made = leaks::made_meshes();
  const bool is_made = std::find(made.begin(), made.end(), name) != made.end();
  return is_made ? leaks::make_mesh(name) : leaks::read_mesh(name);
}

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream stream(file);
  if (!(stream << text)) throw std::runtime_error(file.string() + " cannot be written");
}

int run(const LeakOptions& options) {
  const leaks::ClosedMesh mesh = mesh_called(options.mesh);
  const std::vector<const Subject*> methods = wanted(options.methods);
  std::filesystem::create_directories(options.out);
  keep_on_interrupt();
  ProgressLine progress;
  const leaks::Result result =
      leaks::search(mesh, methods, options.settings, is_interrupted,
                    [&](double done, const std::string& what) { progress.show(done, what); });
  progress.clear();
  const std::filesystem::path out(options.out);
  write(out / "index.html", leaks::html_page(mesh, options.settings, result));
  write(out / "cases.jsonl", leaks::case_lines(result));
  fmt::print("{}: {} triangles, closed; seed {}, {} rays for each precision\n\n{}\n", mesh.name,
             mesh.triangles.size(), options.settings.seed, options.settings.rays, leaks::text_table(result));
  const std::vector<std::string> broken = leaks::broken_promises(result);
  for (const std::string& sentence : broken) fmt::print("{}\n", sentence);
  fmt::print("page: {}\n", (out / "index.html").string());
  if (result.was_interrupted) {
    fmt::print("interrupted: only what is shown was judged\n");
    return 130;
  }
  fmt::print("{}\n",
             broken.empty() ? "no sound method leaks or hits twice" : "NOT every sound method is tight");
  return broken.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Puts rays at a closed mesh's own vertices and edges to the methods of triangles.",
               "rayproof leak");
  LeakOptions options;
  describe(app, options);
  if (const auto status = parse_command_line(app, argc, argv)) return *status;
  try {
    return run(options);
  } catch (const std::runtime_error& trouble) {
    fmt::print(stderr, "rayproof leak: {}\n", trouble.what());
  }
  return 2;
}
