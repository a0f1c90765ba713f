#include "bench/measuring/oracle_contender.hpp"

#include <algorithm>
#include <memory>

#include "oracle/oracle.hpp"
#include "subjects/subject.hpp"

namespace rayproof::report {

namespace {

/// Cases with the answers that are to be judged; few enough to lie in the caches, too many for branch
/// prediction.
struct ClaimedAnswers {
  std::vector<Case> cases;
  std::vector<Answer> answers;
  std::size_t hits = 0;  ///< so that no verdict can be left out
};

Answer nearest_of(Answer answer) {
  if (auto* const ray = std::get_if<RayAnswer>(&answer)) {
    ray->nearest_only = true;
    ray->hits.count = std::min<std::size_t>(ray->hits.count, 1);
  }
  return answer;
}

}  // namespace

Contender oracle_contender(const std::string& topic, const std::vector<Case>& cases) {
  const auto sound = std::ranges::find_if(subjects(), [&](const Subject& one) {
    return one.topic == topic && one.contract.standing == Standing::sound;
  });
  const auto claims = std::make_shared<ClaimedAnswers>();
  claims->cases.assign(cases.begin(), cases.begin() + std::min<std::ptrdiff_t>(std::ssize(cases), 1024));
  for (const Case& one : claims->cases) claims->answers.push_back(nearest_of(sound->answer(one)));
  return {oracle_name, Arrangement::scalar, [claims](std::size_t count) {
            for (std::size_t i = 0; i < count; ++i) {
              const std::size_t place = i % claims->cases.size();
              claims->hits += oracle::judge(claims->cases[place], claims->answers[place]).wrong ? 0 : 1;
            }
          }};
}

}  // namespace rayproof::report
