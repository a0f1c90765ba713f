#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "viz/render/errors.hpp"
#include "viz/render/scene/scene_reader.hpp"

namespace rayproof::render {
namespace {

const std::filesystem::path docs = RAYPROOF_SOURCE_DIR "/docs";

/// The totals of a method on one of the scenes of docs/raycasting.md, at its own size.
Totals totals_of(const std::string& file, const std::string& shape, const std::string& method) {
  const RenderScene scene = read_scene(docs / "scenes" / file, {});
  Methods methods = default_methods();
  methods[shape] = method;
  const auto tree = bounds_tree(scene);
  return find_errors(scene, trace_exactly(scene, tree, {}), trace(scene, methods, nullptr, {}), {}).totals;
}

TEST(TeachingScenes, TheFarSphereHasRingsByTheTextbookAndNoneByTheCentredMethod) {
  EXPECT_GT(totals_of("far-sphere.json", "sphere", "textbook").wrong_hits, 5000U);
  const Totals centred = totals_of("far-sphere.json", "sphere", "centred");
  EXPECT_EQ(centred.wrong(), 0U);
  EXPECT_LE(centred.worst_ulps, 4);
}

TEST(TeachingScenes, TrianglesLeakAlongTheFoldsButNotByWoop) {
  EXPECT_GT(totals_of("triangle-edges.json", "triangle", "moller_trumbore").wrong_misses, 10U);
  EXPECT_EQ(totals_of("triangle-edges.json", "triangle", "woop").wrong_misses, 0U);
  EXPECT_EQ(totals_of("triangle-edges.json", "triangle", "rounded").wrong(), 0U);
}

TEST(TeachingScenes, PrintedParityIsWrongAtTheHeightsOfCorners) {
  EXPECT_GT(totals_of("polygon-vertices.json", "polygon", "printed_parity").wrong_misses, 100U);
  EXPECT_EQ(totals_of("polygon-vertices.json", "polygon", "winding").wrong(), 0U);
}

TEST(TeachingScenes, PaddedSlabsHitAFrameAroundTheBox) {
  EXPECT_EQ(totals_of("box-silhouette.json", "box", "padded").wrong_hits, 232U) << "2·(68 + 50) - 4 pixels";
  EXPECT_EQ(totals_of("box-silhouette.json", "box", "slabs").wrong(), 0U);
}

TEST(TeachingScenes, ABadTransformSpoilsEvenTheCompensatedMethodALittle) {
  const Totals compensated = totals_of("flattened-sphere.json", "sphere", "compensated");
  EXPECT_GT(compensated.wrong(), 0U);
  EXPECT_LT(compensated.wrong(), 100U);
  EXPECT_GT(totals_of("flattened-sphere.json", "sphere", "textbook").wrong(), 5000U);
}

TEST(TeachingScenes, EverySceneIsOnThePageWithItsPicture) {
  std::string page;
  for (const char* const file : {"raycasting.md", "leaving-the-surface.md"}) {
    std::ifstream in(docs / file);
    page.append(std::istreambuf_iterator<char>(in), {});
  }
  for (const auto& entry : std::filesystem::directory_iterator(docs / "scenes")) {
    if (entry.path().extension() != ".json") continue;
    const std::string name = entry.path().stem().string();
    EXPECT_NE(page.find("./rayproof render docs/scenes/" + name + ".json"), std::string::npos) << name;
    EXPECT_NE(page.find("](images/scenes/" + name + ".png)"), std::string::npos) << name;
    EXPECT_TRUE(std::filesystem::exists(docs / "images" / "scenes" / (name + ".png"))) << name;
  }
}

}  // namespace
}  // namespace rayproof::render
