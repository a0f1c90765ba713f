#pragma once
/// \file
/// The fewest causes that explain all complaints of one subject.

#include <memory>

#include "properties/diagnosis/cause_search.hpp"

namespace rayproof::diagnosis {

/// Each complaint is diagnosed by itself first. Of the causes that are named so, those are kept that explain
/// most of the cases of all complaints together: one fault breaks several properties, in both precisions.
class Cover {
 public:
  explicit Cover(std::span<const Complaint* const> complaints);

  /// The groups of each complaint.
  [[nodiscard]] std::vector<std::vector<Diagnosis>> groups() const;

 private:
  /// A complaint with what is thought of it.
  struct Sheet {
    std::unique_ptr<Examination> examination;
    std::unique_ptr<CauseSearch> search;
    std::vector<const Hypothesis*> named;  ///< the causes of its groups where no other complaint is known,
                                           ///< and what one precision may not show
    double weight;                         ///< how many cases of the run a case of the sample stands for
    bool counts_digits;                    ///< digits are lost, and no more
  };
  /// A cause with the cases that it explains of each complaint.
  struct Candidate {
    const Hypothesis* cause = nullptr;
    std::vector<Indices> explained{};
    double against = 0;  ///< how many right answers contradict it, by the weight of their complaints
    std::string_view condition{};  ///< where alone the fault shows, in words; empty where it is not so
  };

  [[nodiscard]] std::vector<Candidate> candidates() const;
  [[nodiscard]] Examination::Mistake common_mistake(const Hypothesis& cause) const;
  [[nodiscard]] bool is_most_somewhere(const Candidate& candidate) const;
  [[nodiscard]] bool shows_in_numbers(const Candidate& candidate) const;
  [[nodiscard]] bool is_named(const Hypothesis& cause) const;
  [[nodiscard]] bool never_finds() const;
  [[nodiscard]] double weight_of_common(const Candidate& one, const std::vector<Indices>& others) const;
  [[nodiscard]] Candidate* model_of(const Candidate& cure, std::vector<Candidate>& candidates) const;
  void name_by_models(std::vector<Candidate>& candidates) const;
  [[nodiscard]] std::vector<Candidate> chosen() const;
  static void take_other_limits(Candidate& taken, std::vector<Candidate>& open);
  [[nodiscard]] Indices kept_for_models(const Candidate& cure, std::size_t complaint,
                                        std::span<const Candidate> open) const;
  [[nodiscard]] std::vector<Diagnosis> groups_of(std::size_t complaint,
                                                 std::span<const Candidate> causes) const;
  [[nodiscard]] bool is_group(const Candidate& one, std::size_t complaint, const Indices& left) const;

  std::vector<Sheet> sheets_{};
};

}  // namespace rayproof::diagnosis
