/// \file
/// rayproof findings: other people's libraries on trial, and the pages of what was found.

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "case/files.hpp"
#include "command_line/command_line.hpp"
#include "command_line/idle_options.hpp"
#include "command_line/progress_line.hpp"
#include "dossier/collection.hpp"
#include "programs/check/peers.hpp"
#include "viz/page/page.hpp"
#include "viz/picture/picture.hpp"

namespace {

using namespace rayproof;
namespace fs = std::filesystem;

/// The command line.
struct FindingsOptions {
  std::vector<std::string> subjects{"peers"};
  std::vector<std::string> from{};
  std::string out = "out/findings";
  std::string cases{}, shape{};
  bool write = false;
};

/// Runs rayproof check; its folder.
fs::path run_check(const FindingsOptions& options) {
  const fs::path folder = fs::path(options.out) / "check";
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path() / "rayproof-check";
  std::string command = check::quoted(program.string()) + " --out " + check::quoted(folder.string()) +
                        " --subject " + check::quoted(fmt::format("{}", fmt::join(options.subjects, ",")));
  if (!options.cases.empty()) command += " --cases " + check::quoted(options.cases);
  if (!options.shape.empty()) command += " --shape " + check::quoted(options.shape);
  const int status = std::system((command + " >/dev/null").c_str());  // NOLINT(concurrency-mt-unsafe)
  if (!WIFEXITED(status) || WEXITSTATUS(status) > 1)
    throw std::runtime_error("the check did not come to its end: " + command);
  return folder;
}

std::string command_of(int argc, char** argv) {
  std::string text = "./rayproof findings";
  for (int i = 1; i < argc; ++i) text += std::string(" ") + argv[i];
  return text;
}

/// The Markdown, its pictures and the findings themselves, in ./docs.
void write_docs(const std::vector<dossier::LibraryDossier>& libraries, const std::string& command) {
  if (!fs::exists("docs/findings.jsonl"))
    throw std::runtime_error("--write: there is no docs/findings.jsonl here: it writes into a checkout");
  fs::remove_all("docs/images/findings");
  make_folder("docs/images/findings");
  write_file("docs/findings.md", findings_markdown(libraries, command));
  write_file("docs/findings.jsonl", findings_file(libraries));
  for (const dossier::LibraryDossier& library : libraries)
    for (const dossier::FiledFinding& one : library.findings)
      write_file(fmt::format("docs/images/findings/{}.svg", one.recorded().finding.number),
                 viz::xml_head + picture_of(one, viz::case_still));
}

int run(const FindingsOptions& options, const std::string& command) {
  make_folder(options.out);
  std::vector<fs::path> folders(options.from.begin(), options.from.end());
  if (folders.empty()) folders.push_back(run_check(options));
  std::vector<std::pair<std::string, std::string>> commands;
  for (const check::Peer& peer : check::peers_called(options.subjects))
    commands.emplace_back(peer.name, peer.command);
  ProgressLine progress;
  const std::vector<dossier::LibraryDossier> libraries = dossier::collect(
      folders, commands,
      [&](double done) { progress.show(done, "each library is asked about its findings again"); });
  progress.clear();
  const fs::path out = options.out;
  write_file(out / "findings.jsonl", findings_file(libraries));
  write_file(out / "index.html",
             findings_page(libraries, {{}, viz::case_figure, viz::scene_style(), "scene.js"}));
  write_file(out / "scene.js", viz::shared_script());
  if (options.write) write_docs(libraries, command);
  for (const dossier::LibraryDossier& library : libraries) {
    const std::size_t count = library.findings.size();
    fmt::print("{} {}: {} finding{}\n", library.facts.name, library.facts.version, count,
               count == 1 ? "" : "s");
  }
  fmt::print("./rayproof bugreport N --from {}: finding N as a report to the library's makers\npage: {}\n",
             (out / "findings.jsonl").string(), (out / "index.html").string());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine app("Puts other people's libraries on trial, and writes the page of what was found.",
                  "rayproof findings");
  FindingsOptions options;
  app.add_option("--subject", options.subjects, "These libraries: names, or `peers` for all (docs/peers.md)")
      ->delimiter(',')
      ->capture_default_str()
      ->type_name("NAME");
  app.add_option("--from", options.from,
                 "Make the page of these checks, and run none: the folders of their --out")
      ->delimiter(',')
      ->type_name("DIR");
  app.add_option("--cases", options.cases, "Cases for each shape, family and precision, as of rayproof check")
      ->type_name("COUNT");
  app.add_option("--shape", options.shape, "Only these shapes")->type_name("SHAPE");
  app.add_option("--out", options.out, "Folder for the page and its findings")
      ->capture_default_str()
      ->type_name("DIR");
  app.add_flag("--write", options.write,
               "Also write docs/findings.md with its pictures, and docs/findings.jsonl");
  app.footer("Exit status: 0 the page is written, 2 it is not.");
  if (const auto status = parse_command_line(app, argc, argv)) return *status;
  try {
    if (!options.from.empty()) refuse_options(app, {"--cases", "--shape"}, "--from runs no check");
    return run(options, command_of(argc, argv));
  } catch (const std::exception& trouble) {
    print_trouble("rayproof findings", trouble);
    return 2;
  }
}
