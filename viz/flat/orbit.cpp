#include "viz/flat/orbit.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace rayproof::viz {

StageCamera turned(const StageCamera& camera, double right, double up) {
  if (camera.is_flat) return camera;
  // The eye goes the other way round: first about the camera's upward axis, then about its new rightward one.
  StageCamera next = camera;
  next.toward = std::cos(right) * camera.toward - std::sin(right) * camera.right;
  next.right = std::cos(right) * camera.right + std::sin(right) * camera.toward;
  next.toward = glm::normalize(std::cos(up) * next.toward - std::sin(up) * camera.up);
  next.right = glm::normalize(next.right - glm::dot(next.right, next.toward) * next.toward);
  next.up = glm::cross(next.toward, next.right);
  return next;
}

}  // namespace rayproof::viz
