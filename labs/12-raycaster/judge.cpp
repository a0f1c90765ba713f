#include "answer_questions.hpp"
#include "raycaster.hpp"

int main() {
  using Numbers = std::vector<double>;
  return rayproof::answer_questions([](vec3 eye, vec3 target, vec3 up, double angle, int width, int height,
                                       const std::vector<Numbers>& spheres) {
    std::vector<SceneSphere> scene;
    for (const Numbers& one : spheres) scene.push_back({{one[0], one[1], one[2]}, one[3]});
    return raycaster({eye, target, up, angle, width, height}, scene);
  });
}
