#include <algorithm>

#include "subjects/subject.hpp"
#include "unit/render/scenes.hpp"
#include "viz/render/errors.hpp"
#include "viz/render/hits.hpp"

namespace rayproof::render {
namespace {

class Trace : public SceneFiles {};

void expect_same(const HitImage& one, const HitImage& other) {
  EXPECT_EQ(one.object, other.object);
  EXPECT_EQ(one.t, other.t);
}

TEST_F(Trace, TakesTheNearestOfTwo) {
  const RenderScene two = scene(scene_text(R"({"shape": {"type": "sphere", "center": [0, 0, 0], "radius": 2}},
      {"shape": {"type": "sphere", "center": [0.25, 0.5, 3], "radius": 0.5}})"));
  const HitImage hits = trace(two, default_methods(), nullptr, {});
  EXPECT_EQ(hits.object[hits.index(20, 15)], 1U);
  EXPECT_EQ(std::count(hits.object.begin(), hits.object.end(), 0U) > 50, true);
  expect_same(hits, [&] {
    RenderScene swapped = two;
    std::swap(swapped.objects[0], swapped.objects[1]);
    HitImage image = trace(swapped, default_methods(), nullptr, {});
    for (ObjectIndex& object : image.object) object = object == no_object ? object : 1 - object;
    return image;
  }());
}

TEST_F(Trace, OfTwoAtTheSameTItTakesTheFirst) {
  const RenderScene twins = scene(scene_text(sphere_entry + ", " + sphere_entry));
  const auto tree = bounds_tree(twins);
  for (const HitImage& hits :
       {trace(twins, default_methods(), nullptr, {}), trace_exactly(twins, tree, {})}) {
    EXPECT_EQ(std::count(hits.object.begin(), hits.object.end(), 1U), 0);
    EXPECT_GT(std::count(hits.object.begin(), hits.object.end(), 0U), 20);
  }
}

TEST_F(Trace, EveryPixelIsTheSameForOneJobAndForMore) {
  const RenderScene mixed = scene(scene_text(mixed_entries, "[101, 67]"));
  const auto tree = bounds_tree(mixed);
  expect_same(trace(mixed, default_methods(), nullptr, {1, nullptr, {}}),
              trace(mixed, default_methods(), nullptr, {2, nullptr, {}}));
  expect_same(trace_exactly(mixed, tree, {1, nullptr, {}}), trace_exactly(mixed, tree, {3, nullptr, {}}));
}

TEST_F(Trace, EachPixelIsWhatTheMethodAnswersToItsCase) {
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    const RenderScene mixed = scene(scene_text(mixed_entries), {precision, {}});
    const HitImage hits = trace(mixed, default_methods(), nullptr, {});
    for (int y = 0; y < mixed.height; y += 3) {
      for (int x = 0; x < mixed.width; x += 3) {
        double nearest = HUGE_VAL;
        for (ObjectIndex object = 0; object < mixed.objects.size(); ++object) {
          const Case one = pixel_case(mixed, x, y, object, {});
          const std::string topic = topic_of(one);
          const auto answer =
              std::get<RayAnswer>(find_subject(topic + "/" + default_methods().at(topic))->answer(one));
          if (answer.hits.count > 0) nearest = std::min(nearest, answer.hits.t[0]);
        }
        EXPECT_EQ(hits.t[hits.index(x, y)], nearest) << x << ' ' << y;
      }
    }
  }
}

TEST_F(Trace, ATreeAndEmbreeLeaveOutNoHit) {
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    const RenderScene many =
        scene(scene_text(many_spheres(12) + "," + mixed_entries, "[96, 72]"), {precision, {}});
    ASSERT_GE(many.objects.size(), many_objects);
    const HitImage all = trace(many, default_methods(), nullptr, {});
    expect_same(all, trace(many, default_methods(), bounds_tree(many, method_margin), {}));
    const auto embree = embree_tree(many, method_margin);
#ifdef RAYPROOF_HAS_EMBREE
    ASSERT_TRUE(embree);
    expect_same(all, trace(many, default_methods(), embree, {}));
#else
    EXPECT_FALSE(embree);
#endif
  }
}

TEST_F(Trace, TheExactImageIsTheOraclesWithNobodyLeftOut) {
  const RenderScene mixed = scene(scene_text(mixed_entries + "," + many_spheres(4), "[30, 22]"));
  const auto tree = bounds_tree(mixed);
  const HitImage hits = trace_exactly(mixed, tree, {});
  for (int y = 0; y < mixed.height; ++y) {
    for (int x = 0; x < mixed.width; ++x) {
      double nearest = HUGE_VAL;
      ObjectIndex first = no_object;
      for (ObjectIndex object = 0; object < mixed.objects.size(); ++object) {
        const ExactHit hit = exact_hit(mixed, object, pixel_ray(mixed, x, y));
        if (!hit.is_hit || !(hit.t < nearest)) continue;
        nearest = hit.t;
        first = object;
      }
      EXPECT_EQ(hits.object[hits.index(x, y)], first) << x << ' ' << y;
      EXPECT_EQ(hits.t[hits.index(x, y)], nearest) << x << ' ' << y;
    }
  }
}

TEST_F(Trace, FortyThousandObjectsAreSearchedThroughATree) {
  const RenderScene crowd = scene(scene_text(many_spheres(200), "[64, 48]"));
  ASSERT_EQ(crowd.objects.size(), 40'000U);
  const auto tree = bounds_tree(crowd);
  const auto near = bounds_tree(crowd, method_margin);
  const ErrorImage errors =
      find_errors(crowd, trace_exactly(crowd, tree, {}), trace(crowd, default_methods(), near, {}), {});
  EXPECT_GT(errors.totals.exact_hits, 1000U);
  EXPECT_EQ(errors.totals.wrong_hits, 0U);
  EXPECT_LT(errors.totals.wrong(), 10U);
}

TEST_F(Trace, AnEmptySceneSeesNothing) {
  const RenderScene empty = scene(scene_text(""));
  const auto tree = bounds_tree(empty);
  for (const HitImage& hits : {trace(empty, default_methods(), nullptr, {}), trace_exactly(empty, tree, {}),
                               trace(empty, default_methods(), tree, {})})
    EXPECT_EQ(std::count(hits.object.begin(), hits.object.end(), no_object), 40 * 30);
}

TEST_F(Trace, EveryMethodOfEveryShapeRenders) {
  const RenderScene mixed = scene(scene_text(mixed_entries, "[24, 18]"));
  for (const std::string& name : renderable_methods()) {
    Methods methods = default_methods();
    const std::size_t slash = name.find('/');
    ASSERT_EQ(methods.count(name.substr(0, slash)), 1U);
    methods[name.substr(0, slash)] = name.substr(slash + 1);
    const HitImage hits = trace(mixed, methods, nullptr, {});
    EXPECT_LT(std::count(hits.object.begin(), hits.object.end(), no_object), 24 * 18) << name;
  }
}

TEST_F(Trace, APixelsCaseIsAboutTheExactObjectAndSaysSo) {
  const RenderScene mixed = scene(scene_text(mixed_entries));
  const PixelHits hits = hits_at(mixed, 20, 15, default_methods());
  EXPECT_EQ(hits.exact, hits.claimed);
  const Case one = pixel_case(mixed, 20, 15, object_of(hits), hits);
  EXPECT_NE(one.note.find("pixel (20, 15)"), std::string::npos);
  EXPECT_NE(one.note.find("shapes[" + std::to_string(hits.exact) + "]"), std::string::npos) << one.note;
  EXPECT_EQ(std::get<RayQuestion>(one.question).ray.direction, pixel_ray(mixed, 20, 15).direction);
  EXPECT_EQ(object_of({no_object, 3}), 3U) << "what only the method hits";
}

}  // namespace
}  // namespace rayproof::render
