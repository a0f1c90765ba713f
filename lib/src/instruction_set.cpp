#include <cstdlib>
#include <rayproof/batch/kernels.hpp>
#include <rayproof/objects/kernels.hpp>
#include <rayproof/spawn/kernels.hpp>
#include <stdexcept>
#include <string>

namespace rayproof {

namespace {

bool has_machine(InstructionSet set) {
#ifdef __x86_64__
  __builtin_cpu_init();
  // The x86-64-v3 and x86-64-v4 levels.
  const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                        __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
  const bool has_avx512 = has_avx2 && __builtin_cpu_supports("avx512f") &&
                          __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd") &&
                          __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
  if (set == InstructionSet::avx2) return has_avx2;
  if (set == InstructionSet::avx512) return has_avx512;
#endif
  return set == InstructionSet::baseline;
}

// RAYPROOF_BUILT_FOR: the sets that the kernels were built for, in ascending order
// (cmake/instruction_sets.cmake).
template <InstructionSet... built>
std::vector<InstructionSet> find_available() {
  std::vector<InstructionSet> found;
  for (const InstructionSet set : {built...}) {
    if (has_machine(set)) found.push_back(set);
  }
  if (found.empty())
    throw std::runtime_error("the batch kernels were built for another machine (RAYPROOF_INSTRUCTION_SETS)");
  return found;
}

InstructionSet choose() {
  const char* wanted = std::getenv("RAYPROOF_ISA");
  if (wanted == nullptr || *wanted == '\0') return available_instruction_sets().back();
  std::string choices;
  for (const InstructionSet set : available_instruction_sets()) {
    if (name_of(set) == wanted) return set;
    choices.append(choices.empty() ? "" : ", ").append(name_of(set));
  }
  throw std::runtime_error("RAYPROOF_ISA is '" + std::string(wanted) + "'; this machine and build have " +
                           choices);
}

/// The table of a set. One that was not built is refused; one that the machine lacks is the caller's to
/// avoid.
template <class Table, InstructionSet... built, class TableOf>
const Table& of_set(InstructionSet set, const TableOf& table_of) {
  const Table* found = nullptr;
  ((set == built ? found = &table_of.template operator()<built>() : nullptr), ...);
  if (found == nullptr)
    throw std::invalid_argument("no kernels are built for instruction set " + std::string(name_of(set)));
  return *found;
}

}  // namespace

std::string_view name_of(InstructionSet set) {
  static constexpr std::string_view names[] = {"baseline", "avx2", "avx512"};
  return names[static_cast<std::size_t>(set)];
}

const std::vector<InstructionSet>& available_instruction_sets() {
  static const std::vector<InstructionSet> available = find_available<RAYPROOF_BUILT_FOR>();
  return available;
}

InstructionSet preferred_instruction_set() {
  static const InstructionSet preferred = choose();
  return preferred;
}

const batch::KernelTable& batch::kernel_table(InstructionSet set) {
  const auto table_of = []<InstructionSet built>() -> const KernelTable& { return built_table<built>(); };
  return of_set<KernelTable, RAYPROOF_BUILT_FOR>(set, table_of);
}
const spawn::KernelTable& spawn::kernel_table(InstructionSet set) {
  const auto table_of = []<InstructionSet built>() -> const KernelTable& { return built_table<built>(); };
  return of_set<KernelTable, RAYPROOF_BUILT_FOR>(set, table_of);
}
const objects::KernelTable& objects::kernel_table(InstructionSet set) {
  const auto table_of = []<InstructionSet built>() -> const KernelTable& { return built_table<built>(); };
  return of_set<KernelTable, RAYPROOF_BUILT_FOR>(set, table_of);
}

}  // namespace rayproof
