#pragma once
/// \file
/// Where and how much float hits differ from the exact ones.

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

/// The step an error belongs to.
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

}  // namespace rayproof::render
