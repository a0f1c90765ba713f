#pragma once
/// \file
/// Searches a closed mesh for rays that slip through between its triangles, or meet it twice at one place.

#include <atomic>
#include <cstdint>
#include <functional>

#include "leaks/aim.hpp"
#include "subjects/subject.hpp"

namespace rayproof::leaks {

struct LeakSettings {
  std::uint64_t seed = 2022;
  std::uint64_t rays = 100'000;  ///< for each precision
  int jobs = 0;                  ///< threads; 0 for as many as the machine has
  std::vector<Precision> precisions{Precision::float32, Precision::float64};
};

/// What may be wrong where a ray crosses the surface once.
enum class LossKind {
  leak,       ///< no triangle around the target is hit: the ray is inside out from there on
  double_hit  ///< triangles around the target are hit at places more than `same_hit_ulps` apart
};
inline constexpr std::array<const char*, 2> failure_names{"leak", "double hit"};

/// Two triangles that share what the ray meets may round its t differently: places on the ray within this
/// many units in the last place of the largest coordinate, the origin's or the patch's, are one hit.
inline constexpr double same_hit_ulps = 8;

/// One ray that a subject lost or met twice.
struct Loss {
  std::uint64_t number = 0;  ///< of the ray
  LossKind failure{};
  Aim aim{};
  std::vector<Case> cases{};               ///< the ray and each triangle of the patch
  std::vector<std::vector<double>> got{};  ///< the t that the subject reports of each
  std::vector<bool> is_hit{};              ///< whether the ray meets it in truth
};

/// Of one subject in one precision.
struct Outcomes {
  const Subject* subject = nullptr;
  Precision precision{};
  std::array<std::uint64_t, target_count> rays{}, leaks{}, doubles{};  ///< by target
  std::uint64_t leaks_from_inside = 0;                                 ///< of the leaks
  std::uint64_t unsupported = 0;  ///< rays with a triangle that the subject says is not for it
  std::uint64_t failed = 0;       ///< rays with a triangle that it failed to answer
  std::optional<std::pair<std::uint64_t, std::string>> failure{};  ///< of the first such ray, in one sentence
  std::array<std::optional<Loss>, 2> first{};                      ///< by LossKind

  [[nodiscard]] std::uint64_t total(const std::array<std::uint64_t, target_count>& counts) const;
  Outcomes& operator+=(const Outcomes& more);
};

struct Result {
  std::vector<Outcomes> outcomes{};
  bool was_interrupted = false;
};

/// Puts the same rays to each subject. The result is the same for every number of jobs.
[[nodiscard]] Result search(const ClosedMesh& mesh, const std::vector<const Subject*>& subjects,
                            const LeakSettings& settings, const std::atomic<bool>& stop,
                            const std::function<void(double, const std::string&)>& progress);

/// Whether a subject is held to it: a sound method must neither leak nor hit twice, nor must anybody else who
/// is put on trial; a method of ours that is not sound has no other choice.
[[nodiscard]] bool is_held_to(const Subject& subject);

}  // namespace rayproof::leaks
