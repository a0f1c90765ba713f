/// \file
/// rayproof draw: draws a case as PNG, SVG or a page.

#include "case/one_file.hpp"
#include "viz/flat/stage_picture.hpp"
#include "viz/page/page.hpp"
#include "viz/picture/picture.hpp"
#include "viz/programs/draw/heat.hpp"
#include "viz/programs/files.hpp"
#ifdef RAYPROOF_HAS_VTK
#include "viz/vtk/offscreen_display.hpp"
#include "viz/vtk/picture_png.hpp"
#include "viz/vtk/raster_png.hpp"
#endif

namespace {

using namespace rayproof;

struct Files {
  std::string png{}, svg{}, html{}, heat{};

  void refuse_wrong_names() const {
    for (const auto& [option, file, suffix] : {std::tuple{"--png", png, ".png"},
                                               {"--svg", svg, ".svg"},
                                               {"--html", html, ".html"},
                                               {"--heat", heat, ".png"}})
      viz::refuse_other_suffix(option, file, suffix);
    const std::pair<const char*, const std::string&> all[] = {
        {"--png", png}, {"--svg", svg}, {"--html", html}, {"--heat", heat}};
    for (const auto* one = std::begin(all); one != std::end(all); ++one)
      for (const auto* other = one + 1; other != std::end(all); ++other)
        refuse_one_file(one->first, one->second, other->first, other->second);
  }
};

void write_picture(const viz::CaseReport& report, const std::string& path) {
#ifdef RAYPROOF_HAS_VTK
  const viz::OffscreenDisplay display;
  const viz::CaseSheet sheet = viz::case_sheet(report);
  std::vector<viz::Inlay> scenes;
  for (std::size_t i = 0; i < sheet.frames.size(); ++i) scenes.push_back({&sheet.stage, i, sheet.frames[i]});
  viz::write_png(viz::PictureCanvas().draw(sheet.picture, scenes), path);
#else
  (void)report;
  throw viz::WrongCommand("--png " + path +
                          " needs VTK, which this build was made without; --svg and --html work");
#endif
}

void draw(const viz::CaseReport& report, const Files& files) {
  if (!files.svg.empty()) write_file(files.svg, viz::xml_head + viz::to_svg(viz::case_picture(report)));
  if (!files.html.empty()) write_file(files.html, viz::case_page(report));
  if (!files.png.empty()) write_picture(report, files.png);
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine app("Draws a case with its exact answer and, where a method is given, that method's.",
                  "rayproof draw");
  viz::CaseOptions options;
  options.add_to(app);
  Files files;
  app.add_option("--png", files.png, "Write a PNG, drawn by VTK")->type_name("FILE");
  app.add_option("--svg", files.svg, "Write an SVG")->type_name("FILE");
  app.add_option("--html", files.html,
                 "Write a page with the picture and the method's steps; for the number of a finding without "
                 "any FILE, draw-N.html beside the findings")
      ->type_name("FILE");
  app.add_option(
         "--heat", files.heat,
         "Write a PNG of a sphere or triangle with the method's errors as colours on it, for rays from "
         "the case's origin to all that it sees")
      ->type_name("FILE");
  if (const auto status = parse_command_line(app, argc, argv)) return *status;

  return viz::run_and_report("rayproof draw", [&] {
    const bool is_named = !(files.png + files.svg + files.html + files.heat).empty();
    if (!is_named) files.html = viz::page_beside_findings(options, "draw");
    if (!is_named && files.html.empty())
      throw viz::WrongCommand("nothing to write: give --png, --svg, --html or --heat and a file");
    files.refuse_wrong_names();
    const viz::CaseReport report = viz::report_case(options);
    if (!files.heat.empty()) viz::write_heat_map(report, files.heat);
    if (!(files.png + files.svg + files.html).empty()) draw(report, files);
    if (!is_named) fmt::print("{}\n", files.html);
  });
}
