#include "viz/programs/render/options.hpp"

#include <algorithm>
#include <charconv>

#include "case/reader/near_names.hpp"
#include "viz/programs/files.hpp"
#include "viz/render/shading.hpp"

namespace rayproof::render {
namespace {

/// "640x480" as two sides.
std::pair<int, int> parse_size(const std::string& text) {
  std::pair<int, int> size;
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.first);
  const bool has_x = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
  const auto height = has_x ? std::from_chars(width.ptr + 1, end, size.second) : width;
  const auto is_side = [](int side) { return 1 <= side && side <= largest_side; };
  if (!has_x || height.ec != std::errc() || height.ptr != end || !is_side(size.first) ||
      !is_side(size.second)) {
    throw WrongCommand(fmt::format("--size must be WIDTHxHEIGHT, each from 1 to {}, as 640x480, not {}",
                                   largest_side, text));
  }
  return size;
}

std::vector<std::string> known_strategies() {
  std::vector<std::string> names = strategy_names();
  names.emplace_back("all");
  return names;
}

void choose(Methods& methods, const std::string& full_name) {
  const std::vector<std::string> known = renderable_methods();
  if (std::ranges::find(known, full_name) == known.end()) {
    throw WrongCommand(fmt::format("there is no method {} to render with; did you mean {}?", full_name,
                                   fmt::join(near_names(full_name, known, 3), " or ")));
  }
  const std::size_t slash = full_name.find('/');
  methods[full_name.substr(0, slash)] = full_name.substr(slash + 1);
}

}  // namespace

void RenderOptions::add_to(CLI::App& app) {
  app.add_option("SCENE", scene, "The scene, a JSON file (docs/raycasting.md)");
  app.add_option("--out", out, "The image to write, a PNG")->type_name("IMAGE");
  app.add_option("--method", methods,
                 "The method for a shape, as in sphere/textbook; several times for several shapes")
      ->type_name("SHAPE/METHOD")
      ->allow_extra_args(false);
  app.add_option("--precision", precision, "Round the scene to this in place of its own precision")
      ->check(CLI::IsMember({"float32", "float64"}));
  app.add_option("--size", size, "The image's size in place of the scene's own")->type_name("WIDTHxHEIGHT");
  app.add_option("--shade", shade,
                 "normal: darker where the surface turns away (the default); flat: one colour a shape")
      ->check(CLI::IsMember({"normal", "flat"}));
  app.add_option("--jobs", jobs, "Threads; as many as the machine has where left out")
      ->check(CLI::Range(1, 1024));
  app.add_flag("--exact", is_exact, "Let the oracle decide every pixel");
  CLI::Option* const asked =
      app.add_option(
             "--error", error,
             "Draw where and how much the methods differ from the exact image; one more may be given here")
          ->type_name("[SHAPE/METHOD]")
          ->expected(0, 1)
          ->allow_extra_args(false);
  app.add_option("--compare", compare, "Draw the errors of two methods side by side")
      ->type_name("SHAPE/METHOD")
      ->expected(2)
      ->allow_extra_args(false);
  app.add_option("--spawn", strategies,
                 "Draw the light and its shadows, with shadow rays started by a strategy, or by all of them")
      ->type_name("STRATEGY")
      ->delimiter(',')
      ->check(CLI::IsMember(known_strategies()));
  app.add_flag(
      "--window", is_window,
      "Show --error or --compare in a window; a click on a pixel prints its case and writes its page");
  app.add_option("--case", pixel,
                 "Print the case of the pixel in column X and row Y, from 0 at the top left; with --out "
                 "FILE.html also write its page, by --error's method if one is given")
      ->type_name("X Y")
      ->expected(2)
      ->allow_extra_args(false);
  app.final_callback([this, asked] {
    is_error = asked->count() > 0;
    std::erase(error, "");
    // What stands behind --error may also be the scene.
    if (scene.empty() && !error.empty()) {
      scene = error.back();
      error.pop_back();
    }
    if (scene.empty()) throw CLI::RequiredError("SCENE");
  });
  app.footer(
      "Exit status: 0 done, 1 the scene is refused, 2 wrong command line or a file can't be read, 130 "
      "interrupted.");
}

Mode RenderOptions::mode() const {
  const bool is_pixel = !pixel.empty();
  const int kinds = static_cast<int>(is_exact) + static_cast<int>(is_error || is_pixel) +
                    static_cast<int>(!compare.empty()) + static_cast<int>(!strategies.empty());
  if (kinds > 1)
    throw WrongCommand("only one of --exact, --error, --compare, --spawn and --case can be done at a time");
  if (is_exact && !methods.empty()) throw WrongCommand("--exact asks no method: leave --method out");
  if (is_pixel && !out.empty() && !out.ends_with(".html"))
    throw WrongCommand("--case prints a case and draws no image: leave --out out, or name a page.html");
  if (is_window && (is_pixel || (!is_error && compare.empty())))
    throw WrongCommand("--window shows errors: give --error or --compare");
  if (!is_pixel && !is_window && out.empty()) throw WrongCommand("nothing to write: give --out and a file");
  if (is_pixel) return Mode::pixel;
  viz::refuse_other_suffix("--out", out, ".png");
  if (!compare.empty()) return Mode::compare;
  if (is_error) return Mode::error;
  if (!strategies.empty()) return Mode::shadows;
  return is_exact ? Mode::exact_picture : Mode::picture;
}

SceneOverrides RenderOptions::overrides() const {
  SceneOverrides given;
  if (!precision.empty()) given.precision = precision_named(precision);
  if (!size.empty()) given.size = parse_size(size);
  return given;
}

Methods RenderOptions::chosen_methods(const std::vector<std::string>& more) const {
  Methods chosen = default_methods();
  for (const std::string& name : methods) choose(chosen, name);
  for (const std::string& name : more) choose(chosen, name);
  return chosen;
}

}  // namespace rayproof::render
