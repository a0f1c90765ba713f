/// \file
/// Embree over our own kernels: an analytic routine takes the place of Embree's intersection, as user
/// geometry (P. Drábek, "Geometrie pro počítačovou grafiku", 2017, replaces `rtcIntersect` so). Embree finds
/// whom to ask; the method and its precision stay ours.

#include "viz/render/neighbourhood.hpp"

#ifdef RAYPROOF_HAS_EMBREE

#include <embree3/rtcore.h>

#include <cmath>
#include <limits>

namespace rayproof::render {
namespace {

/// A query under way: Embree's context, and after it what is done with each object.
struct Query {
  RTCIntersectContext context;
  const Meet* meet;
};

float rounded_down(double x) { return std::nextafter(static_cast<float>(x), -HUGE_VALF); }
float rounded_up(double x) { return std::nextafter(static_cast<float>(x), HUGE_VALF); }

class EmbreeTree final : public Neighbourhood {
 public:
  explicit EmbreeTree(ObjectBounds bounds)
      : bounds_(std::move(bounds)), device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(bounds_.boxes.size()));
    rtcSetGeometryUserData(geometry, &bounds_);
    rtcSetGeometryBoundsFunction(geometry, bound, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(scene_);
  }
  ~EmbreeTree() override {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  EmbreeTree(const EmbreeTree&) = delete;
  EmbreeTree& operator=(const EmbreeTree&) = delete;

  void visit(const Ray<double>& ray, const Meet& meet) const override {
    for (const ObjectIndex object : bounds_.unbounded) meet(object);
    Query query{{}, &meet};
    rtcInitIntersectContext(&query.context);
    RTCRayHit hit{};
    hit.ray.org_x = static_cast<float>(ray.origin.x);
    hit.ray.org_y = static_cast<float>(ray.origin.y);
    hit.ray.org_z = static_cast<float>(ray.origin.z);
    hit.ray.dir_x = static_cast<float>(ray.direction.x);
    hit.ray.dir_y = static_cast<float>(ray.direction.y);
    hit.ray.dir_z = static_cast<float>(ray.direction.z);
    hit.ray.tnear = 0;
    hit.ray.tfar = std::numeric_limits<float>::infinity();
    hit.ray.mask = ~0U;
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_, &query.context, &hit);
  }

 private:
  static void bound(const RTCBoundsFunctionArguments* asked) {
    const Bounds& box = static_cast<const ObjectBounds*>(asked->geometryUserPtr)->boxes[asked->primID];
    RTCBounds& out = *asked->bounds_o;
    out.lower_x = rounded_down(box.low.x);
    out.lower_y = rounded_down(box.low.y);
    out.lower_z = rounded_down(box.low.z);
    out.upper_x = rounded_up(box.high.x);
    out.upper_y = rounded_up(box.high.y);
    out.upper_z = rounded_up(box.high.z);
  }

  static void intersect(const RTCIntersectFunctionNArguments* asked) {
    if (asked->valid[0] == 0) return;
    const auto* query = reinterpret_cast<const Query*>(asked->context);
    const auto* bounds = static_cast<const ObjectBounds*>(asked->geometryUserPtr);
    const double nearest = (*query->meet)(bounds->boxed[asked->primID]);
    if (!(nearest < HUGE_VAL)) return;
    // Rounded up, so that an object at the same t is still asked.
    RTCRayN_tfar(RTCRayHitN_RayN(asked->rayhit, 1), 1, 0) = rounded_up(nearest * (1 + 0x1p-20));
    RTCHitN_geomID(RTCRayHitN_HitN(asked->rayhit, 1), 1, 0) = asked->geomID;
  }

  ObjectBounds bounds_;
  RTCDevice device_;
  RTCScene scene_;
};

}  // namespace

std::unique_ptr<Neighbourhood> embree_tree(ObjectBounds bounds) {
  return std::make_unique<EmbreeTree>(std::move(bounds));
}

}  // namespace rayproof::render

#else

namespace rayproof::render {

std::unique_ptr<Neighbourhood> embree_tree(ObjectBounds /*bounds*/) { return nullptr; }

}  // namespace rayproof::render

#endif
