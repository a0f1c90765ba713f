#include "properties/diagnosis/models/cylinders/readings.hpp"

#include <cmath>

#include "properties/diagnosis/models/cylinders/ends.hpp"

namespace rayproof::diagnosis {
namespace {

template <class DoChange>
std::vector<Case> with_cylinder(const Case& one, DoChange&& change) {
  return with_shape<Cylinder<double>>(one, [&](RayQuestion& /*asked*/, Cylinder<double>& cylinder) {
    change(cylinder);
    return true;
  });
}

std::vector<Case> with_radii_times(const Case& one, double factor) {
  return with_cylinder(one, [factor](Cylinder<double>& cylinder) {
    cylinder.rx *= factor;
    cylinder.ry *= factor;
  });
}

}  // namespace

std::vector<Case> with_caps(const Case& one) {
  return with_cylinder(one, [](Cylinder<double>& cylinder) { cylinder.capped = true; });
}
std::vector<Case> without_caps(const Case& one) {
  return with_cylinder(one, [](Cylinder<double>& cylinder) { cylinder.capped = false; });
}
std::vector<Case> circular_rx(const Case& one) {
  return with_cylinder(one, [](Cylinder<double>& cylinder) { cylinder.ry = cylinder.rx; });
}
std::vector<Case> circular_ry(const Case& one) {
  return with_cylinder(one, [](Cylinder<double>& cylinder) { cylinder.rx = cylinder.ry; });
}
std::vector<Case> radii_exchanged(const Case& one) {
  return with_cylinder(one, [](Cylinder<double>& cylinder) { std::swap(cylinder.rx, cylinder.ry); });
}
std::vector<Case> radii_squared(const Case& one) {
  return with_cylinder(one, [](Cylinder<double>& cylinder) {
    cylinder.rx *= cylinder.rx;
    cylinder.ry *= cylinder.ry;
  });
}
namespace {

/// The cylinder lower by that share of its height.
std::vector<Case> lowered(const Case& one, double share) {
  return with_shape<Cylinder<double>>(one, [share](RayQuestion& asked, const Cylinder<double>& cylinder) {
    lift(asked, -share * cylinder.height);
    return true;
  });
}

}  // namespace

std::vector<Case> middle_at_zero(const Case& one) { return lowered(one, 0.5); }
std::vector<Case> top_at_zero(const Case& one) { return lowered(one, 1); }

std::vector<Case> radii_doubled(const Case& one) { return with_radii_times(one, 2); }
std::vector<Case> radii_halved(const Case& one) { return with_radii_times(one, 0.5); }
std::vector<Case> radii_rooted(const Case& one) {
  return with_cylinder(one, [](Cylinder<double>& cylinder) {
    cylinder.rx = std::sqrt(cylinder.rx);
    cylinder.ry = std::sqrt(cylinder.ry);
  });
}
std::vector<Case> radii_mean(const Case& one) {
  return with_cylinder(one, [](Cylinder<double>& c) { c.rx = c.ry = (c.rx + c.ry) / 2; });
}
std::vector<Case> height_doubled(const Case& one) {
  return with_cylinder(one, [](Cylinder<double>& cylinder) { cylinder.height *= 2; });
}
std::vector<Case> height_halved(const Case& one) {
  return with_cylinder(one, [](Cylinder<double>& cylinder) { cylinder.height /= 2; });
}

std::vector<Case> radii_one(const Case& one) {
  return with_cylinder(one, [](Cylinder<double>& cylinder) { cylinder.rx = cylinder.ry = 1; });
}
std::vector<Case> height_one(const Case& one) {
  return with_cylinder(one, [](Cylinder<double>& cylinder) { cylinder.height = 1; });
}

std::vector<Case> rx_rooted(const Case& one) {
  return with_cylinder(one, [](Cylinder<double>& cylinder) { cylinder.rx = std::sqrt(cylinder.rx); });
}
std::vector<Case> ry_rooted(const Case& one) {
  return with_cylinder(one, [](Cylinder<double>& cylinder) { cylinder.ry = std::sqrt(cylinder.ry); });
}
std::vector<Case> height_rooted(const Case& one) {
  return with_cylinder(one, [](Cylinder<double>& cylinder) { cylinder.height = std::sqrt(cylinder.height); });
}

std::vector<Case> cylinder_as_box(const Case& one) {
  return with_question(one, [](RayQuestion& asked) {
    const auto* cylinder = std::get_if<Cylinder<double>>(&asked.shape);
    if (cylinder == nullptr) return false;
    const glm::dvec3 corner(cylinder->rx, cylinder->ry, 0);
    asked.shape = Box<double>{-corner, corner + glm::dvec3(0, 0, cylinder->height)};
    return true;
  });
}

}  // namespace rayproof::diagnosis
