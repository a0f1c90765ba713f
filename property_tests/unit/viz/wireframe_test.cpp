#include <gtest/gtest.h>

#include <cmath>
#include <rayproof/topics.hpp>

#include "case/reader.hpp"
#include "generators/generators.hpp"
#include "oracle/oracle.hpp"
#include "subjects/our_subject.hpp"
#include "subjects/solve_point_in_polygon.hpp"
#include "subjects/solve_quadratic.hpp"
#include "subjects/solve_shapes.hpp"
#include "viz/even_odd.hpp"
#include "viz/record.hpp"
#include "viz/told.hpp"
#include "viz/topics.hpp"
#include "viz/topics/camera.hpp"
#include "viz/topics/figure.hpp"

namespace rayproof::viz {
namespace {

constexpr const char* ray_head =
    R"({"precision":"float32","ray":{"origin":[0.25,0.25,-5],"direction":[0,0,1]},)";

Case with_shape(const std::string& shape) { return read_case(ray_head + shape + "}"); }

const std::vector<std::string>& shapes() {
  static const std::vector<std::string> all{
      R"("shape":{"type":"plane","normal":[0,0.5,1],"d":-1})",
      R"("shape":{"type":"plane","point":[0,0,1],"normal":[0,0.5,1]})",
      R"("shape":{"type":"plane","point":[0,0,1],"u":[1,0,0],"v":[0,1,-0.5]})",
      R"("shape":{"type":"triangle","a":[0,0,0],"b":[1,0,0],"c":[0,1,0]})",
      R"("shape":{"type":"polygon","vertices":[[0,0,0],[1,0,0],[1,1,0],[0,1,0]]})",
      R"("shape":{"type":"sphere","center":[0,0,0],"radius":1})",
      R"("shape":{"type":"box","min":[-1,-1,-1],"max":[1,1,1]})",
      R"("shape":{"type":"parallelepiped","corner":[-1,-1,0],"edges":[[3,0,0],[0,3,0],[0,0,1]]})",
      R"("shape":{"type":"cylinder","rx":1,"ry":2,"height":1,"capped":true})"};
  return all;
}

template <class Kind>
std::vector<Kind> elements(const Picture& picture) {
  std::vector<Kind> found;
  for (const Element& element : picture.elements) {
    if (const auto* one = std::get_if<Kind>(&element)) found.push_back(*one);
  }
  return found;
}

/// Marks inside the first frame, the table's own below it left out.
std::size_t count_marks(const Picture& picture, MarkShape shape) {
  std::size_t count = 0;
  for (const Mark& mark : elements<Mark>(picture)) count += mark.shape == shape && mark.at.y < 388 ? 1U : 0U;
  return count;
}

TEST(Views, EveryTopicHasOne) {
  Topics::for_each([]<class Topic>(std::type_identity<Topic>) {
    const auto& views = topic_views();
    EXPECT_EQ(std::count_if(views.begin(), views.end(), [](const auto& v) { return v.name == Topic::name; }),
              1)
        << Topic::name;
  });
}

bool same_bits(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || (a == b && std::signbit(a) == std::signbit(b));
}

TEST(Stories, OfEveryRecordableMethodEndInTheKernelsOwnNumbersBitForBit) {
  std::size_t told = 0;
  for (const Family& family : families()) {
    const Case one = family.generate(7, Precision::float32);
    Topics::for_each([&]<class Topic>(std::type_identity<Topic>) {
      if (topic_of(one) != Topic::name) return;
      Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
        const auto walk = view_of(one)->walk(one, Method::name);
        if constexpr (Recordable<Method, Recorded<float, Shadow>>) {
          ASSERT_TRUE(walk) << Topic::name << '/' << Method::name;
          const auto roots = solve_in<Topic, Method, float>(one);
          EXPECT_TRUE(same_bits(walk->lo, roots.lo)) << Topic::name << '/' << Method::name;
          EXPECT_TRUE(same_bits(walk->hi, roots.hi)) << Topic::name << '/' << Method::name;
          EXPECT_FALSE(walk->steps.empty()) << Topic::name << '/' << Method::name;
          ++told;
        } else {
          EXPECT_FALSE(walk) << Topic::name << '/' << Method::name;
        }
      });
    });
  }
  EXPECT_GT(told, 100U);
}

TEST(Stories, NameTheInputsByTheLettersOfTheFormat) {
  const auto names = [](const std::string& shape, const std::string& method) {
    const Case one = with_shape(shape);
    const Walkthrough told = view_of(one)->walk(one, method).value();
    std::string all;
    for (const WalkValue& value : told.inputs) all += value.name + ' ';
    return all;
  };
  EXPECT_EQ(names(shapes()[0], "implicit"), "o.x o.y o.z d⃗.x d⃗.y d⃗.z n.x n.y n.z d ");
  EXPECT_EQ(names(shapes()[2], "parametric"), "o.x o.y o.z d⃗.x d⃗.y d⃗.z p.x p.y p.z u.x u.y u.z v.x v.y v.z ");
  EXPECT_EQ(names(shapes()[3], "cramer"), "o.x o.y o.z d.x d.y d.z a.x a.y a.z b.x b.y b.z c.x c.y c.z ");
  EXPECT_EQ(names(shapes()[5], "centred"), "o.x o.y o.z d.x d.y d.z C.x C.y C.z r ");
  EXPECT_EQ(names(shapes()[8], "centred"), "o.x o.y o.z d.x d.y d.z rx ry height ");
}

TEST(Stories, AMethodThatCantBeRecordedSaysSoAndStillAnswers) {
  const Case one =
      read_case(R"({"query":"point_in_polygon","point":[0,0],"vertices":[[-1,-1],[1,-1],[0,1]]})");
  const Told told{one, oracle::answer(one), "point_in_polygon/parity", Position::inside, {}};
  const std::string text = explain_text(told);
  EXPECT_NE(text.find("can't be recorded step by step; its answer is right."), std::string::npos) << text;
  EXPECT_NE(text.find("inside"), std::string::npos) << text;
}

TEST(Stories, AComparisonBesideATieIsBlamedForAWrongVerdict) {
  const Case one = with_shape(shapes()[3]);
  const Told told{one, oracle::answer(one), "triangle/cramer", RayAnswer{},
                  view_of(one)->walk(one, "cramer")};
  EXPECT_NE(conclusion_of(told).find("a comparison is so near a tie"), std::string::npos)
      << conclusion_of(told);
}

TEST(Wireframe, MarksEveryHitOfEveryShape) {
  for (const std::string& shape : shapes()) {
    const Case one = with_shape(shape);
    const Answer exact = oracle::answer(one);
    const std::size_t hits = std::get<RayAnswer>(exact).hits.count;
    const Picture picture = view_of(one)->picture(one, &exact, &exact);
    EXPECT_GE(count_marks(picture, MarkShape::ring), hits) << shape;
    EXPECT_GE(count_marks(picture, MarkShape::cross), hits) << shape;
    EXPECT_GE(hits, 1U) << shape;
    EXPECT_FALSE(elements<Area>(picture).empty()) << shape;
  }
}

TEST(Wireframe, AHugeATinyAndAFarSceneStayInsideThePicture) {
  for (const std::string& shape : shapes()) {
    for (const char* const matrix : {"[[1e150,0,0,0],[0,1e150,0,0],[0,0,1e150,0],[0,0,0,1]]",
                                     "[[1e-150,0,0,0],[0,1e-150,0,0],[0,0,1e-150,0],[0,0,0,1]]",
                                     "[[1,0,0,1e200],[0,1,0,0],[0,0,1e-200,0],[0,0,0,1]]"}) {
      const Case one = read_case(R"({"ray":{"origin":[1,2,-5],"direction":[0,0.1,1]},"transform":)" +
                                 std::string(matrix) + "," + shape + "}");
      const Answer exact = oracle::answer(one);
      const Picture picture = view_of(one)->picture(one, &exact, nullptr);
      for (const Line& line : elements<Line>(picture)) {
        for (const Point& p : line.points) {
          ASSERT_TRUE(p.x >= 0 && p.x <= picture.width && p.y >= 0 && p.y <= picture.height)
              << shape << matrix << p.x << ' ' << p.y;
        }
      }
    }
  }
}

TEST(Wireframe, AGapTooNarrowToSeeIsMagnified) {
  const Case one = read_case(
      R"({"ray":{"origin":[0.3,-1e-9,-5],"direction":[0,0,1]},"shape":{"type":"triangle","a":[0,0,0],"b":[1,0,0],"c":[0,1,0]}})");
  const Answer exact = oracle::answer(one);
  RayAnswer wrong{Contact::crossing};
  wrong.hits.push_back(5);
  const Answer claimed = wrong;
  bool is_told = false;
  const Picture picture = view_of(one)->picture(one, &exact, &claimed);
  for (const Text& text : elements<Text>(picture)) is_told = is_told || text.text == "1e-9 between";
  EXPECT_TRUE(is_told);
}

TEST(Camera, SeesNeitherTheRayEndOnNorAFigureEdgeOn) {
  for (const Place& ray : {Place{0, 0, 1}, Place{1, 0, 0}, unit({1, 2, 3}), unit({0, -1, 1e-9})}) {
    for (const Place& normal : {Place{0, 0, 1}, Place{0, 1, 0}, unit({1, -1, 1})}) {
      const Camera camera = Camera::chosen({0, 0, 0}, ray, {normal});
      EXPECT_LT(abs(dot(camera.toward, ray)), Shadow(0.75));
      EXPECT_GT(abs(dot(camera.toward, normal)), Shadow(0.4));
      EXPECT_LT(abs(camera.see(ray).y), Shadow(1e-60));
      EXPECT_GT(camera.see(ray).x, Shadow(0.5));
    }
  }
}

TEST(EvenOdd, FillsAStarsPointsAndNotItsHeart) {
  Picture picture;
  const View view{{0, 0, 200, 200}, {0, 0}, 100, 100};
  std::vector<WorldPoint> star;
  for (int i = 0; i < 5; ++i) {
    const double angle = i * 4 * std::acos(-1.0) / 5;
    star.push_back({Shadow(std::sin(angle)), Shadow(std::cos(angle))});
  }
  draw_even_odd(picture, view, Role::surface, star);
  double area = 0;
  for (const Area& part : elements<Area>(picture)) {
    const double height = part.points[2].y - part.points[0].y;
    area += height * (part.points[1].x - part.points[0].x + part.points[2].x - part.points[3].x) / 2;
  }
  // Five points of a pentagram in the unit circle: 1.1226 in all less the heart of 0.3469.
  EXPECT_NEAR(area / 1e4, 1.1226 - 0.3469, 0.02);
}

TEST(ConvexHull, LeavesOutWhatLiesInside) {
  EXPECT_EQ(convex_hull({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 0}}).size(), 4U);
}

}  // namespace
}  // namespace rayproof::viz
