#include "viz/programs/render/options.hpp"

#include "case/shape_format.hpp"
#include "viz/page/page.hpp"
#include "viz/programs/files.hpp"
#include "viz/programs/report_of.hpp"
#include "viz/vtk/picture_png.hpp"
#include "viz/walkthrough/lesson.hpp"

namespace rayproof::render {

PixelReport report_pixel(const RenderScene& scene, int x, int y, const Methods& methods) {
  if (x < 0 || x >= scene.width || y < 0 || y >= scene.height) {
    throw WrongCommand(
        fmt::format("pixel {} {} is outside the image of {}x{} pixels", x, y, scene.width, scene.height));
  }
  const PixelHits hits = hits_at(scene, x, y, methods);
  const ObjectIndex object = object_of(hits);
  if (object == no_object) {
    throw WrongCommand(
        fmt::format("the ray of pixel {} {} meets nothing, neither exactly nor by the methods, so that "
                    "there is no case to print",
                    x, y));
  }
  const std::string shape = shape_name(scene.objects[object].shape);
  return {pixel_case(scene, x, y, object, hits), shape + "/" + methods.at(shape)};
}

void write_page(const PixelReport& report, const std::string& path) {
  viz::PictureCanvas canvas;
  const viz::Stage stage = viz::stage_of(viz::report_of(report.one, report.method));
  write_file(path, viz::stage_page(stage, [&](const viz::Stage& shown, std::size_t step) {
               return viz::still_of(canvas, shown, step);
             }));
}

}  // namespace rayproof::render
