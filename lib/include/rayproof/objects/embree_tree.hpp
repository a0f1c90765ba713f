#pragma once
/// \file
/// The search through boxes by Intel's Embree 3, many times faster: for who links it (CMake's target
/// `embree`).
///
/// An analytic routine takes the place of Embree's intersection, as user geometry: Embree finds whom to ask;
/// the method and its precision stay ours. Source: P. Drábek, "Geometrie pro počítačovou grafiku", 2017,
/// replaces `rtcIntersect` so.

#include <embree3/rtcore.h>

#include <limits>
#include <memory>
#include <rayproof/objects/bounds_tree.hpp>
#include <rayproof/objects/embree_ray.hpp>
#include <stdexcept>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof::objects {

/// Has the interface of BoundsTree, and can stand in its place: ObjectTree<float, PlainMethods, EmbreeTree>.
///
/// Embree searches in float. So its boxes are larger by a margin that covers the rounding of the ray, too; a
/// ray from so far away that this margin is not enough, one that begins before t = 0, and one with numbers
/// that float cannot hold are searched for in a BoundsTree.
class EmbreeTree {
 public:
  explicit EmbreeTree(std::vector<Bounds> boxes) : tree_(boxes) {
    if (boxes.empty()) return;
    reach_ = reach_of(tree_.bounds());
    for (Bounds& box : boxes) box = box.grown(margin * reach_);
    RTCDevice device = rtcNewDevice(nullptr);
    if (device == nullptr) throw std::runtime_error("Embree makes no device on this machine");
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    scene_ = {rtcNewScene(device), rtcReleaseScene};
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(boxes.size()));
    rtcSetGeometryUserData(geometry, boxes.data());
    rtcSetGeometryBoundsFunction(geometry, give_bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry, meet_one);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_.get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(scene_.get());
    rtcReleaseDevice(device);
  }

  /// As BoundsTree's.
  template <class Meet>
  void visit(const RayAgainstBoxes& ray, double t_max, Meet&& meet) const {
    if (!suits(ray)) {
      tree_.visit(ray, t_max, meet);
      return;
    }
    // The direction is made about as long as 1, since Embree takes what is below 1e-18 for that.
    const auto [origin, direction, t_first, t_last] = ray.ray();
    const int length = std::ilogb(reach_of(direction));
    Query query{{}, &meet, length, [](const void* asked, unsigned i) {
                  return (*static_cast<const std::remove_reference_t<Meet>*>(asked))(i);
                }};
    rtcInitIntersectContext(&query.context);
    const auto scaled = [&](double x) { return static_cast<float>(std::scalbn(x, -length)); };
    const float first = rounded_down(std::scalbn(t_first, length) * (1 - doubt));
    RTCRayHit hit = embree_ray({convert<float>(origin),
                                {scaled(direction.x), scaled(direction.y), scaled(direction.z)},
                                std::max(0.0F, first),
                                query.limit(std::min(t_last, t_max))});
    rtcIntersect1(scene_.get(), &query.context, &hit);
  }

  [[nodiscard]] Bounds bounds() const { return tree_.bounds(); }

 private:
  /// How much larger the boxes are, in parts of the largest coordinate.
  static constexpr double margin = 0x1p-13;
  /// What rounding the ray to float moves it by at most, in parts of its origin and the largest coordinate.
  static constexpr double rounding = 0x1p-22;
  /// Outweighs the roundings of t.
  static constexpr double doubt = 0x1p-20;

  /// A search under way: Embree's context, which stands first, and what is done with each object.
  struct Query {
    RTCIntersectContext context;
    const void* meet;
    int length;  ///< log2 of the direction's, of which t' = t·2^length is in units
    double (*call)(const void* meet, unsigned i);

    /// Rounded up, so that an object at the same t is still asked.
    [[nodiscard]] float limit(double t) const {
      return rounded_up(std::scalbn(t, length) * (1 + (t > 0 ? doubt : -doubt)));
    }
  };

  [[nodiscard]] static float rounded_down(double x) {
    return std::nextafter(static_cast<float>(x), -HUGE_VALF);
  }
  [[nodiscard]] static float rounded_up(double x) { return std::nextafter(static_cast<float>(x), HUGE_VALF); }

  [[nodiscard]] bool suits(const RayAgainstBoxes& ray) const {
    constexpr double smallest = 0x1p-60, largest = 0x1p+60;
    const auto is_ordinary = [](double x) { return smallest < x && x < largest; };
    const double far = reach_of(ray.ray().origin) + reach_;
    return scene_ && is_ordinary(reach_) && is_ordinary(reach_of(ray.ray().direction)) &&
           ray.ray().t_min >= 0 && ray.margin() + rounding * far <= margin * reach_;
  }

  static void give_bounds(const RTCBoundsFunctionArguments* asked) {
    const Bounds& box = static_cast<const Bounds*>(asked->geometryUserPtr)[asked->primID];
    *asked->bounds_o = {rounded_down(box.low.x), rounded_down(box.low.y), rounded_down(box.low.z), 0,
                        rounded_up(box.high.x),  rounded_up(box.high.y),  rounded_up(box.high.z),  0};
  }

  static void meet_one(const RTCIntersectFunctionNArguments* asked) {
    if (asked->valid[0] == 0) return;
    const auto& query = *reinterpret_cast<const Query*>(asked->context);
    const double t_max = query.call(query.meet, asked->primID);
    if (t_max == HUGE_VAL) return;
    float& t_far = RTCRayN_tfar(RTCRayHitN_RayN(asked->rayhit, 1), 1, 0);
    t_far = std::isnan(t_max) ? -HUGE_VALF : std::min(t_far, query.limit(t_max));
    RTCHitN_geomID(RTCRayHitN_HitN(asked->rayhit, 1), 1, 0) = asked->geomID;
  }

  BoundsTree tree_;
  double reach_ = 0;
  std::shared_ptr<RTCSceneTy> scene_{};
};

}  // namespace rayproof::objects

#include <rayproof/rounding/as_before.hpp>
