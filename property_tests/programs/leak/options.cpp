#include "programs/leak/options.hpp"

#include "command_line/count_option.hpp"
#include "command_line/precision_option.hpp"
#include "command_line/run_options.hpp"

namespace rayproof::leaks {

namespace {

constexpr const char* footer =
    "MESH is cube, sphere, torus or knot, or a file in OFF, OBJ, STL or PLY; it must be closed.\n"
    "Writes DIR/index.html, with a picture of each kind of loss, and DIR/cases.jsonl.\n"
    "Exit status: 0 no sound method and nobody else on trial leaks or hits twice; 1 not so; 2 wrong command "
    "line, or a mesh that cannot be used; 130 interrupted.";

void describe_subjects(CLI::App& app, LeakOptions& options) {
  app.add_option("--method", options.methods, "Only these methods of triangles: woop, or triangle/woop")
      ->delimiter(',');
  app.add_option(
         "--subject-command", options.command,
         "Put this program on trial: a shell line that reads cases, one a line, on standard input and writes "
         "an answer to each (docs/your-own-code.md); our methods only where --method names them")
      ->type_name("COMMAND")
      ->check(no_blank_command());
  app.add_option("--subject", options.subjects,
                 "Put these libraries on trial: names, or `peers` for all that are built (docs/peers.md)")
      ->delimiter(',')
      ->type_name("NAME");
  add_case_seconds_option(app, options.case_seconds);
}

}  // namespace

void describe(CLI::App& app, LeakOptions& options) {
  LeakSettings& settings = options.settings;
  app.add_option("MESH", options.mesh, "The mesh")->capture_default_str();
  describe_subjects(app, options);
  add_seed_option(app, settings.seed, "Where the random rays begin");
  app.add_option("--rays", settings.rays, "Rays for each precision")
      ->capture_default_str()
      ->transform(whole_count());
  add_jobs_option(app, settings.jobs);
  add_precision_option(app, settings.precisions);
  app.add_option("--out", options.out, "Folder for the page and the cases")
      ->capture_default_str()
      ->type_name("DIR");
  app.add_option("--json", options.json, "Write all figures as one JSON object")->type_name("FILE");
  app.footer(footer);
}

}  // namespace rayproof::leaks
