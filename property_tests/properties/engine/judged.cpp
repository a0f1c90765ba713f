#include "properties/engine/judged.hpp"

#include <algorithm>

namespace rayproof {

std::span<oracle::JudgedAnswers> JudgedBlocks::block(std::uint64_t block_seed, unsigned cases) {
  auto found = std::ranges::find(blocks_, block_seed, [](const auto& block) { return block.first; });
  if (found == blocks_.end()) {
    if (blocks_.size() == most_blocks) blocks_.pop_front();
    found = blocks_.emplace(blocks_.end(), block_seed, std::vector<oracle::JudgedAnswers>());
  }
  if (found->second.size() < cases) found->second.resize(cases);
  return found->second;
}

}  // namespace rayproof
