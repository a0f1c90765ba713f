#pragma once
/// \file
/// An answer in 24 bytes, by whose bits two builds are compared.

#include <array>
#include <bit>
#include <cstdint>

#include "case/answer.hpp"

namespace rayproof::builds {

/// The bytes in the order of the machine. Numbers are compared as bits, so that no comparison of floats is
/// left to the flags of a build; all NaN are one.
struct Record {
  std::uint32_t verdict = 0;         ///< how many hits or roots, and of which kind; or the position
  std::uint32_t rest = 2166136261U;  ///< a hash of all that is neither verdict nor t
  std::array<std::uint64_t, 2> t{};  ///< the bits of the first two t or roots, as doubles
};
static_assert(sizeof(Record) == 24);

[[nodiscard]] inline std::uint64_t bits_of(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  constexpr std::uint64_t infinity_bits = 0x7ff0000000000000U, sign_bit = 0x8000000000000000U;
  return (bits & ~sign_bit) > infinity_bits ? infinity_bits + 1 : bits;
}

/// Adds bits to a hash (FNV-1a).
inline void add_bits(std::uint32_t& hash, std::uint64_t bits) {
  for (int byte = 0; byte < 8; ++byte, bits >>= 8U)
    hash = (hash ^ static_cast<std::uint32_t>(bits & 0xffU)) * 16777619U;
}

[[nodiscard]] inline Record record_of(Position position) {
  return {.verdict = static_cast<std::uint32_t>(position)};
}

[[nodiscard]] inline Record record_of(const QuadraticAnswer<double>& roots) {
  Record record{.verdict =
                    16 * static_cast<std::uint32_t>(roots.kind) + static_cast<std::uint32_t>(roots.count)};
  for (std::size_t i = 0; i < 2; ++i)
    if (i < static_cast<std::size_t>(roots.count)) record.t[i] = bits_of(roots.roots[i]);
  return record;
}

[[nodiscard]] inline Record record_of(const RayAnswer& answer) {
  Record record{.verdict = static_cast<std::uint32_t>(answer.hits.count)};
  for (std::size_t i = 0; i < 2 && i < answer.hits.count; ++i) record.t[i] = bits_of(answer.hits.t[i]);
  add_bits(record.rest, static_cast<std::uint64_t>(answer.contact));
  const auto add = [&](const auto& vector) {
    if (vector)
      for (int i = 0; i < vector->length(); ++i) add_bits(record.rest, bits_of((*vector)[i]));
  };
  add(answer.point);
  add(answer.normal);
  add(answer.barycentric);
  add(answer.parameters);
  return record;
}

}  // namespace rayproof::builds
