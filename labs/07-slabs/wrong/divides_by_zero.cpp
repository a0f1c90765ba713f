// Diagnosis: 0·∞ is NaN in the slab of a face that the ray runs in
#include "slabs.hpp"

#include <cmath>
#include <utility>

std::vector<double> slabs(vec3 origin, vec3 direction, double t_min, double t_max, vec3 min, vec3 max) {
  double enter = -INFINITY, leave = INFINITY;
  for (int i = 0; i < 3; ++i) {
    double near = (min[i] - origin[i]) / direction[i];
    double far = (max[i] - origin[i]) / direction[i];
    if (near > far) std::swap(near, far);
    enter = std::fmax(enter, near);
    leave = std::fmin(leave, far);
  }
  std::vector<double> hits;
  if (enter > leave) return hits;
  if (t_min <= enter && enter <= t_max) hits.push_back(enter);
  if (t_min <= leave && leave <= t_max) hits.push_back(leave);
  return hits;
}
