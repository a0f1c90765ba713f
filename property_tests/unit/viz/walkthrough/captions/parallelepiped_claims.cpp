#include <array>
#include <cmath>
#include <string>

#include "unit/viz/walkthrough/captions/caption.hpp"

namespace rayproof::viz {
namespace {

constexpr std::array<const char*, 3> edges{"e₀", "e₁", "e₂"};
constexpr std::array<const char*, 3> normals{"n₀", "n₁", "n₂"};

double volume_size(const NumbersByName& n) {
  return glm::length(n.vector("e₀")) * glm::length(n.vector("e₁")) * glm::length(n.vector("e₂"));
}

double volume(const NumbersByName& n) {
  return glm::dot(n.vector("e₀"), glm::cross(n.vector("e₁"), n.vector("e₂")));
}

}  // namespace

std::vector<CheckedClaim> parallelepiped_claims() {
  return {
      {"Each is the cross product of the two edges that span a pair of faces.",
       [](const Said& s) {
         for (std::size_t i = 0; i < 3; ++i) {
           const glm::dvec3 a = s.n.vector(edges.at((i + 1) % 3)), b = s.n.vector(edges.at((i + 2) % 3));
           EXPECT_TRUE(
               are_equal(s.n.vector(normals.at(i)), glm::cross(a, b), glm::length(a) * glm::length(b)));
           EXPECT_TRUE(are_perpendicular(s.n.vector(normals.at(i)), a, 1e-13));
         }
       }},
      {"Two faces with one normal n bound a slab; the ray meets them at t = n·f / (n·d) and t = (n·f + n·e) "
       "/ "
       "(n·d).",
       [](const Said& s) {
         const glm::dvec3 f = s.n.vector("f");
         for (std::size_t i = 0; i < 3; ++i) {
           const glm::dvec3 n = s.n.vector(normals.at(i));
           const double ahead = s.n[normals.at(i) + std::string("·f")];
           EXPECT_TRUE(are_equal(ahead, glm::dot(n, f), glm::length(n) * glm::length(f)));
         }
       }},
      {"In real numbers all three n·e are the volume of the solid.",
       [](const Said& s) {
         for (std::size_t i = 0; i < 3; ++i) {
           const double one = s.n[normals.at(i) + std::string("·") + edges.at(i)];
           EXPECT_TRUE(are_equal(one, volume(s.n), volume_size(s.n)));
         }
       }},
      {"The edges are the columns of the map; row i of its inverse is nᵢ / (nᵢ·eᵢ), where each n·e is the "
       "volume of the solid.",
       [](const Said& s) {
         const glm::dvec3 all = s.n.vector("n·e");
         for (int i = 0; i < 3; ++i) EXPECT_TRUE(are_equal(all[i], volume(s.n), volume_size(s.n)));
       }},
      {"The inverse map applies to origin and direction alike, so t is the same; from here on o and d are "
       "the "
       "ray in the cube's space.",
       [](const Said& s) {
         if (s.n.vector("n·e").x == 0) return;
         const glm::dvec3 x = s.n.vector("e₀"), y = s.n.vector("e₁"), z = s.n.vector("e₂");
         const auto expect = [&](const char* name, const glm::dvec3& given, double given_size) {
           const glm::dvec3 m = s.n.vector(name);
           const double size = std::abs(m.x) * glm::length(x) + std::abs(m.y) * glm::length(y) +
                               std::abs(m.z) * glm::length(z);
           EXPECT_TRUE(are_equal(m.x * x + m.y * y + m.z * z, given, size + given_size)) << name;
         };
         const glm::dvec3 o = s.n.origin(), corner = s.n.input("corner");
         expect("o", o - corner, glm::length(o) + glm::length(corner));
         expect("d", s.n.direction(), 0);
       }}};
}

}  // namespace rayproof::viz
