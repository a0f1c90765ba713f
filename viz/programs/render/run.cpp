#include "viz/programs/render/options.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <set>

#include "case/case.hpp"
#include "case/print_to_stderr.hpp"
#include "case/writer.hpp"
#include "command_line/progress_line.hpp"
#include "viz/programs/files.hpp"
#include "viz/render/shading.hpp"
#include "viz/vtk/offscreen_display.hpp"
#include "viz/vtk/picture_png.hpp"
#include "viz/vtk/render/error_figure.hpp"
#include "viz/vtk/render/mesh_reader.hpp"

namespace rayproof::render {
namespace {

class Render {
 public:
  Render(const RenderOptions& options, const std::atomic<bool>& stop)
      : options_(options),
        stop_(stop),
        mode_(options.mode()),
        scene_(read_scene(options.scene, read_mesh, options.overrides())) {
    for (const auto& [option, names] :
         {std::pair{"--method", options.methods}, {"--error", options.error}, {"--compare", options.compare}})
      for (const std::string& name : names) expect_shape_of(option, name);
  }

  void run() {
    if (mode_ == Mode::pixel) return print_case();
    if (options_.is_window) return show_window();
    viz::PartialFile file(options_.out);
    viz::write_png(image(), file.path());
    if (stop_) throw Stopped();
    file.keep();
    fmt::print("{}: {}x{} pixels, {} {}, {}\n", options_.out, scene_.width, scene_.height,
               scene_.objects.size(), scene_.objects.size() == 1 ? "object" : "objects", status_);
  }

 private:
  /// A method of a shape that the scene has none of would change nothing.
  void expect_shape_of(const char* option, const std::string& method) const {
    (void)options_.chosen_methods({method});  // refuses one that there is not
    const std::string shape = method.substr(0, method.find('/'));
    const auto is_of_it = [&](const Object& object) { return shape_name(object.shape) == shape; };
    if (std::ranges::none_of(scene_.objects, is_of_it))
      throw WrongCommand(fmt::format("{} {}: there is no {} in {}", option, method, shape, options_.scene));
  }

  [[nodiscard]] Work work(const std::string& what) {
    return {options_.jobs, &stop_, [this, what](double done) { progress_.show(done, what); }};
  }

  viz::Raster image() {
    if (mode_ == Mode::picture) {
      const HitImage hits = by_methods(options_.chosen_methods(), "by the methods");
      return shaded(scene_, hits, options_.shading(), work("shading"));
    }
    if (mode_ == Mode::exact_picture) return shaded(scene_, exactly(), options_.shading(), work("shading"));
    if (mode_ == Mode::shadows) return shadows();
    const viz::OffscreenDisplay display;
    return error_figure(title(), error_panels());
  }

  using NamedMethods = std::vector<std::pair<std::string, Methods>>;

  /// What --error or --compare asks for.
  [[nodiscard]] NamedMethods asked() const {
    NamedMethods all;
    for (const std::string& method : options_.compare)
      all.emplace_back(method, options_.chosen_methods({method}));
    if (mode_ != Mode::error) return all;
    const Methods chosen = options_.chosen_methods(options_.error);
    return {{names_of(chosen), chosen}};
  }

  /// The methods of the shapes that are in the scene.
  [[nodiscard]] std::string names_of(const Methods& methods) const {
    std::set<std::string> names;
    for (const Object& object : scene_.objects) {
      const std::string shape = shape_name(object.shape);
      names.insert(shape + "/" + methods.at(shape));
    }
    return fmt::format("{}", fmt::join(names, ", "));
  }

  [[nodiscard]] std::string title() const {
    return fmt::format("Errors in {}, against the exact image", name_of(scene_.precision));
  }

  std::vector<ErrorPanel> error_panels() {
    const NamedMethods all = asked();
    std::vector<ErrorPanel> panels(all.size(), {{}, {scene_.width, scene_.height, {}, {}, {}}});
    check_size(panels);  // before the long work
    panels.clear();
    const HitImage exact = exactly();
    std::string comparison;
    for (const auto& [name, methods] : all) {
      const HitImage claimed = by_methods(methods, name);
      panels.push_back({name, find_errors(scene_, exact, claimed, work("comparing"))});
      const Totals& totals = panels.back().errors.totals;
      comparison += fmt::format(
          "\n  {}: {} wrong hits, {} wrong misses, {} wrong objects; t of {} hits, {:.0f} ulp off at most",
          name, totals.wrong_hits, totals.wrong_misses, totals.wrong_objects, totals.hits, totals.worst_ulps);
    }
    status_ = "against the exact image" + comparison;
    progress_.clear();
    return panels;
  }

  void show_window() {
    const viz::UserDisplay display;
    const std::vector<ErrorPanel> panels = error_panels();
    if (stop_) throw Stopped();
    const viz::Raster figure = error_figure(title(), panels);
    if (!options_.out.empty()) viz::write_png(figure, options_.out);
    ErrorWindow window(figure, ErrorLayout(panels), [&, all = asked()](const PanelPixel& pixel) {
      return open(pixel, all[pixel.panel].second);
    });
    window.run();
  }

  /// Prints the case of a pixel and writes its page where the program was started.
  std::string open(const PanelPixel& pixel, const Methods& methods) {
    try {
      const PixelReport report = report_pixel(scene_, pixel.x, pixel.y, methods);
      fmt::print("{}\n", write_case(report.one));
      std::fflush(stdout);
      const std::string page =
          fmt::format("{}-{}-{}.html", std::filesystem::path(scene_.file).stem().string(), pixel.x, pixel.y);
      write_page(report, page);
      print_to_stderr("saved {}\n", page);
      return fmt::format("pixel {} {} by {}: {}", pixel.x, pixel.y, report.method, page);
    } catch (const std::runtime_error& failure) {
      print_to_stderr("rayproof render: {}\n", failure.what());
      return failure.what();
    }
  }

  viz::Raster shadows() {
    if (!scene_.light) throw WrongCommand(options_.scene + " has no light, which --spawn needs");
    const viz::OffscreenDisplay display;
    const Methods methods = options_.chosen_methods();
    const HitImage hits = by_methods(methods, "by the methods");
    const bool is_all = std::ranges::find(options_.strategies, "all") != options_.strategies.end();
    std::vector<ShadowPanel> panels;
    for (const std::string& strategy : is_all ? strategy_names() : options_.strategies) {
      const LightImage light = light_up(scene_, strategy, methods, work(strategy));
      panels.push_back({fmt::format("{}: {} acne, {} leaks", strategy, light.acne, light.leaks),
                        shaded(scene_, light, hits)});
      status_ += fmt::format("\n  {}", panels.back().title);
    }
    progress_.clear();
    return shadow_figure(panels);
  }

  HitImage by_methods(const Methods& methods, const std::string& what) {
    const auto start = std::chrono::steady_clock::now();
    HitImage hits = trace(scene_, methods, near_methods(), work(what));
    report_time(names_of(methods), start);
    return hits;
  }

  HitImage exactly() {
    const auto start = std::chrono::steady_clock::now();
    HitImage hits = trace_exactly(scene_, bounds_tree(scene_), work("exactly"));
    report_time("exactly", start);
    return hits;
  }

  void report_time(const std::string& what, std::chrono::steady_clock::time_point start) {
    progress_.clear();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    status_ = fmt::format("{}{}{:.2f} s", what, what.empty() ? "" : ", ", taken.count());
  }

  /// Whom to ask in a scene of many objects; none where all are asked.
  const Neighbourhood& near_methods() {
    if (near_ || scene_.objects.size() < many_objects) return near_;
    near_ = embree_tree(scene_, method_margin);
    if (near_) return near_;
    print_to_stderr("rayproof render: without Embree in this build, {} objects are searched more slowly\n",
                    scene_.objects.size());
    return near_ = bounds_tree(scene_, method_margin);
  }

  void print_case() {
    const Methods methods = options_.chosen_methods(options_.error);
    const PixelReport report = report_pixel(scene_, options_.pixel[0], options_.pixel[1], methods);
    fmt::print("{}\n", write_case(report.one));
    if (options_.out.empty()) return;
    const viz::OffscreenDisplay display;
    write_page(report, options_.out);
  }

  const RenderOptions& options_;
  const std::atomic<bool>& stop_;
  Mode mode_;
  RenderScene scene_;
  ProgressLine progress_{};
  std::string status_{};
  Neighbourhood near_{};
};

}  // namespace

void run(const RenderOptions& options, const std::atomic<bool>& stop) { Render(options, stop).run(); }

}  // namespace rayproof::render
