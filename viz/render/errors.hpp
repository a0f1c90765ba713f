#pragma once
/// \file
/// Where and how much float hits differ from the exact ones.

#include <cmath>

#include "viz/picture/raster.hpp"
#include "viz/render/hits.hpp"

namespace rayproof::render {

/// What a pixel's float hit is worth. Verdict errors and errors of t are different things and stay apart.
enum class Verdict : std::uint8_t {
  miss,         ///< neither hits anything
  hit,          ///< both hit the same object, or one at the same exact t: t can be compared
  wrong_hit,    ///< hits where nothing is
  wrong_miss,   ///< sees nothing where something is
  wrong_object  ///< hits an object that is not the nearest
};

/// The error of t is counted in ulps from the correctly rounded t, in steps of eight.
struct UlpStep {
  double from;        ///< ulps, the step's lower end
  const char* label;  ///< as a legend has it
};
inline constexpr std::array<UlpStep, 7> ulp_steps{{{0, "0"},
                                                   {1, "1"},
                                                   {2, "2 to 7"},
                                                   {8, "8 to 63"},
                                                   {64, "64 to 511"},
                                                   {512, "512 to 4095"},
                                                   {4096, "4096 and more"}}};
[[nodiscard]] std::size_t step_of(double ulps);

struct Totals {
  std::size_t pixels = 0;
  std::size_t exact_hits = 0;
  std::size_t wrong_hits = 0, wrong_misses = 0, wrong_objects = 0;
  std::size_t hits = 0;                               ///< whose t is compared
  std::array<std::size_t, ulp_steps.size()> steps{};  ///< how many of them fall into each step
  double worst_ulps = 0;                              ///< of them

  [[nodiscard]] std::size_t wrong() const { return wrong_hits + wrong_misses + wrong_objects; }
};

struct ErrorImage {
  int width = 0;
  int height = 0;
  std::vector<Verdict> verdicts{};
  std::vector<double> ulps{};  ///< 0 but where both hit
  Totals totals{};
};

/// Compares the claimed hits with the exact ones. Throws Stopped.
[[nodiscard]] ErrorImage find_errors(const RenderScene& scene, const HitImage& exact, const HitImage& claimed,
                                     const Work& work);

using viz::Rgb;
using viz::rgb_of;

inline constexpr Rgb background = rgb_of("#ffffff");

/// In the order of the scene's shapes, and again from the first.
inline constexpr std::array<Rgb, 7> object_colours{rgb_of("#0072b2"), rgb_of("#e69f00"), rgb_of("#009e73"),
                                                   rgb_of("#cc79a7"), rgb_of("#56b4e9"), rgb_of("#d55e00"),
                                                   rgb_of("#f0e442")};

/// The colour with its light taken down to a share.
[[nodiscard]] inline Rgb dimmed(const Rgb& colour, double by) {
  Rgb dim{};
  for (std::size_t i = 0; i < 3; ++i) dim[i] = static_cast<std::uint8_t>(std::lround(colour[i] * by));
  return dim;
}

/// One for each of `ulp_steps`, ever darker.
inline constexpr std::array<Rgb, ulp_steps.size()> ulp_colours{
    rgb_of("#eef2f5"), rgb_of("#cfe1f2"), rgb_of("#93c3df"), rgb_of("#5aa1cf"),
    rgb_of("#2c79b5"), rgb_of("#0b4f94"), rgb_of("#062a56")};

/// A wrong verdict is shown by a colour, by a pattern of a darker one, and by whether the exact image has
/// something there.
enum class Hatching { rising, falling, dotted };
struct VerdictStyle {
  Verdict verdict;
  Rgb colour, ink;
  Hatching hatching;
  const char* label;
};
inline constexpr std::array<VerdictStyle, 3> verdict_styles{{
    {Verdict::wrong_hit, rgb_of("#e8731a"), rgb_of("#7d3200"), Hatching::rising,
     "wrong hit: nothing is there"},
    {Verdict::wrong_miss, rgb_of("#f5e14a"), rgb_of("#5c5200"), Hatching::falling,
     "wrong miss: something is there"},
    {Verdict::wrong_object, rgb_of("#d88fb7"), rgb_of("#661f48"), Hatching::dotted,
     "wrong object: another comes first"},
}};

[[nodiscard]] constexpr Rgb hatched(const VerdictStyle& style, int x, int y) {
  constexpr int period = 8, stroke = 3;
  bool is_ink = false;
  if (style.hatching == Hatching::rising) is_ink = (x + y) % period < stroke;
  if (style.hatching == Hatching::falling) is_ink = ((x - y) % period + period) % period < stroke;
  if (style.hatching == Hatching::dotted) is_ink = x % period < stroke && y % period < stroke;
  return is_ink ? style.ink : style.colour;
}

}  // namespace rayproof::render
