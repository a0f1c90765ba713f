#include "bench/report/describe_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "command_line/run_options.hpp"

namespace rayproof::report {

namespace {

constexpr const char* footer =
    "Filters may be given several times, or as lists with commas. The page is DIR/index.html, the plots are "
    "PNG files\n"
    "beside it. Times are medians; for figures to quote, let the machine do nothing else. "
    "RAYPROOF_ISA=baseline, avx2 or\n"
    "avx512 chooses the instruction set of the batches.\n"
    "Exit status: 0 everything was measured and written; 2 wrong command line, or something could not be "
    "read or written; 130 interrupted.";

}  // namespace

void describe(CLI::App& app, BenchOptions& options) {
  app.add_option("--shape,--topic", options.shapes, fmt::format("Only {}", fmt::join(topics(), ", ")))
      ->delimiter(',');
  app.add_option("--method", options.methods, "Only this method: centred, or sphere/centred")->delimiter(',');
  app.add_option("--family", options.families, "Only this family of cases")->delimiter(',');
  app.add_option("--precision", options.precisions, "Only float32 or float64")
      ->delimiter(',')
      ->check(CLI::IsMember({"float32", "float64"}));
  app.add_option(
         "--scaling", options.scaling,
         fmt::format("Only these curves, and of the methods nothing: {}", fmt::join(scaling_names, ", ")))
      ->delimiter(',');
  app.add_option(
         "--rays", options.rays,
         "Rays (or equations) of each family, timed and judged; where left out 32768 at most are judged")
      ->capture_default_str()
      ->check(CLI::Range(std::size_t{64}, std::size_t{100'000'000}));
  app.add_option("--time", options.seconds, "Seconds of timing for each family and precision")
      ->capture_default_str()
      ->check(seconds_between(1e-6, 3600));
  app.add_flag("--quick", options.is_quick,
               "Two minutes in place of ten: 4096 rays and 0.02 seconds, where no others are given");
  app.add_option("--baseline", options.baseline,
                 "Compare with the figures of an older report, or of another machine")
      ->check(CLI::ExistingFile)
      ->type_name("FILE");
  app.add_option("--figures", options.figures, "Show the figures of a report in place of measuring")
      ->check(CLI::ExistingFile)
      ->type_name("FILE");
  app.add_option("--out", options.out, "Folder for the page and the plots")
      ->capture_default_str()
      ->type_name("DIR");
  app.add_option("--json", options.json, "Write all figures as one JSON object")->type_name("FILE");
  app.footer(footer);
}

}  // namespace rayproof::report
