/// \file
/// rayproof draw: draws a case as PNG, SVG or a page.

#include <cmath>

#include "case/json/number_text.hpp"
#include "case/one_file.hpp"
#include "viz/flat/stage_picture.hpp"
#include "viz/page/page.hpp"
#include "viz/picture/picture.hpp"
#include "viz/programs/files.hpp"
#ifdef RAYPROOF_HAS_VTK
#include "viz/vtk/offscreen_display.hpp"
#include "viz/vtk/picture_png.hpp"
#include "viz/vtk/render/error_figure.hpp"
#endif

namespace {

using namespace rayproof;

struct Files {
  std::string png{}, svg{}, html{}, heat{};

  void refuse_wrong_names() const {
    const std::tuple<const char*, const std::string&, const char*> all[] = {
        {"--png", png, ".png"}, {"--svg", svg, ".svg"}, {"--html", html, ".html"}, {"--heat", heat, ".png"}};
    for (const auto& [option, file, suffix] : all) viz::refuse_other_suffix(option, file, suffix);
    for (const auto* one = std::begin(all); one != std::end(all); ++one)
      for (const auto* other = one + 1; other != std::end(all); ++other)
        refuse_one_file(std::get<0>(*one), std::get<1>(*one), std::get<0>(*other), std::get<1>(*other));
  }
};

#ifdef RAYPROOF_HAS_VTK
void write_picture(const viz::CaseReport& report, const std::string& path) {
  const viz::OffscreenDisplay display;
  const viz::CaseSheet sheet = viz::case_sheet(report);
  std::vector<viz::Inlay> scenes;
  for (std::size_t i = 0; i < sheet.frames.size(); ++i) scenes.push_back({&sheet.stage, i, sheet.frames[i]});
  viz::write_png(viz::PictureCanvas().draw(sheet.picture, scenes), path);
}

/// The case with its ray aimed at a place.
Case aimed_at(Case one, const glm::dvec3& place) {
  Ray<double>& ray = std::get<RayQuestion>(one.question).ray;
  for (int axis = 0; axis < 3; ++axis)
    ray.direction[axis] = round_to(one.precision, place[axis] - ray.origin[axis]);
  return one;
}

double error_of(const Case& one, const Subject& subject) {
  const Answer exact = oracle::answer(one);
  const Answer claimed = subject.answer(one);
  return viz::verdicts_differ(&exact, &claimed) ? -1 : viz::worst_ulps(&exact, &claimed, one.precision);
}

/// Aims a ray from the case's origin at every small part of its shape's surface, asks the method and the
/// oracle, and writes the errors as colours on it.
void write_heat_map(const viz::CaseReport& report, const std::string& path) {
  const Subject* const subject = find_subject(report.method);
  if (subject == nullptr) throw viz::WrongCommand("--heat needs a method of this program: give --method");
  const auto* const asked = std::get_if<RayQuestion>(&report.one.question);
  if (asked == nullptr || asked->transform || !render::has_heat_map(asked->shape))
    throw viz::WrongCommand("--heat is for a ray and a sphere or triangle without a transform");
  const auto words = [&](const render::HeatTotals& totals) -> render::HeatWords {
    const std::string worst =
        std::isinf(totals.worst_ulps) ? "infinitely far" : fmt::format("{:.0f} ulp", totals.worst_ulps);
    return {fmt::format("{} in {}, over the surface", report.method, name_of(report.one.precision)),
            fmt::format("{} rays from the case's origin: {} wrong verdicts; where right, t is {} off at most",
                        totals.rays, totals.wrong, worst)};
  };
  const viz::OffscreenDisplay display;
  viz::write_png(
      render::heat_map(
          asked->shape, asked->ray.origin,
          [&](const glm::dvec3& place) { return error_of(aimed_at(report.one, place), *subject); }, words),
      path);
}
#else
void write_picture(const viz::CaseReport& /*report*/, const std::string& path) {
  throw viz::WrongCommand("--png " + path +
                          " needs VTK, which this build was made without; --svg and --html work");
}
void write_heat_map(const viz::CaseReport& /*report*/, const std::string& path) {
  throw viz::WrongCommand("--heat " + path + " needs VTK, which this build was made without");
}
#endif

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
    if (!files.heat.empty()) write_heat_map(report, files.heat);
    if (!(files.png + files.svg + files.html).empty()) draw(report, files);
    if (!is_named) fmt::print("{}\n", files.html);
  });
}
