#include "subjects/pool.hpp"

#include <utility>

namespace rayproof {
namespace {

struct IdleAnswerers {
  std::mutex mutex{};
  std::vector<std::unique_ptr<Answerer>> idle{};

  std::unique_ptr<Answerer> take() {
    const std::lock_guard lock(mutex);
    if (idle.empty()) return nullptr;
    std::unique_ptr<Answerer> one = std::move(idle.back());
    idle.pop_back();
    return one;
  }
  void give(std::unique_ptr<Answerer> one) {
    const std::lock_guard lock(mutex);
    idle.push_back(std::move(one));
  }
};

class LentAnswerer final : public Answerer {
 public:
  LentAnswerer(std::shared_ptr<IdleAnswerers> home, std::unique_ptr<Answerer> own)
      : home_(std::move(home)), own_(std::move(own)) {}
  LentAnswerer(const LentAnswerer&) = delete;
  LentAnswerer& operator=(const LentAnswerer&) = delete;
  ~LentAnswerer() override { home_->give(std::move(own_)); }

  void answer(std::span<const Case> cases, std::span<Outcome> outcomes) override {
    own_->answer(cases, outcomes);
  }
  void forget() override { own_->forget(); }

 private:
  std::shared_ptr<IdleAnswerers> home_;
  std::unique_ptr<Answerer> own_;
};

}  // namespace

StartAnswerer pooled(StartAnswerer start) {
  return [start = std::move(start), home = std::make_shared<IdleAnswerers>()]() -> std::unique_ptr<Answerer> {
    std::unique_ptr<Answerer> own = home->take();
    if (!own) own = start();
    return std::make_unique<LentAnswerer>(home, std::move(own));
  };
}

}  // namespace rayproof
