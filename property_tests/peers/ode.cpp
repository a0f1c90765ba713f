/// \file
/// ODE 0.16, dCollide of a ray with a sphere, box, cylinder, plane and triangle mesh. Its manual: at most one
/// contact, where the ray meets the surface, "regardless of whether the ray starts from inside or outside the
/// shape"; `depth` is the distance from the ray's start. A ray has a length, and its direction need not.
#include <ode/ode.h>

#include <memory>

#include "peers/reproduction.hpp"
#include "peers/segment.hpp"

namespace rayproof {
namespace {

using glm::dvec3;
using Hit = std::optional<double>;

/// dReal: what this ODE was built for.
using T = dReal;
using Vector = glm::vec<3, T>;

struct DestroyGeom {
  void operator()(dGeomID geometry) const { dGeomDestroy(geometry); }
};
using Geometry = std::unique_ptr<dxGeom, DestroyGeom>;

using peers::given;
using peers::LibraryCall;

/// A call that begins so, with the geometry's numbers.
template <class... V>
LibraryCall call_on(const char* geometry, const peers::Given<V>&... inputs) {
  LibraryCall call("dCollide",
                   "#include <ode/ode.h>\ndInitODE2(0), dAllocateODEDataForThread(dAllocateMaskAll);");
  call.add(geometry, inputs...);
  return call;
}

/// The nearest hit of a segment with a geometry.
Hit meet(LibraryCall call, dGeomID geometry, const peers::Segment<T>& segment) {
  const Vector whole = segment.end - segment.start;
  const T length = glm::length(whole);
  call.add(R"(dGeomID ray = dCreateRay(nullptr, $length);
dGeomRaySet(ray, $origin, $direction), dGeomRaySetClosestHit(ray, 1);
dContactGeom contact = {};
int hit = dCollide(ray, geometry, 1, &contact, sizeof contact);
std::printf("hit = %d, depth = $g\n", hit, contact.depth);)",
           given("length", length), given("origin", segment.start), given("direction", whole));
  call.ask();
  const Geometry ray(dCreateRay(nullptr, length));
  dGeomRaySet(ray.get(), segment.start.x, segment.start.y, segment.start.z, whole.x, whole.y, whole.z);
  dGeomRaySetClosestHit(ray.get(), 1);
  dGeomRaySetBackfaceCull(ray.get(), 0);
  dContactGeom contact{};
  const int hit = dCollide(ray.get(), geometry, 1, &contact, sizeof contact);
  call.said(given("hit", hit), given("depth", contact.depth));
  if (hit == 0) return {};
  return segment.t_at(static_cast<double>(contact.depth / length));
}

Hit sphere(const Ray<T>& ray, Vector center, T radius) {
  if (radius == 0) throw Unsupported();  // "the radius must be positive"
  const Geometry geometry(dCreateSphere(nullptr, radius));
  dGeomSetPosition(geometry.get(), center.x, center.y, center.z);
  return meet(call_on("dGeomID geometry = dCreateSphere(nullptr, $radius);\n"
                      "dGeomSetPosition(geometry, $center);",
                      given("radius", radius), given("center", center)),
              geometry.get(),
              peers::segment_past<T>(convert<double>(ray), dvec3(center), static_cast<double>(radius)));
}

Hit box(const Ray<T>& ray, Vector low, Vector high) {
  const Vector half = (high - low) / T(2), center = low + half;
  // ODE's box has a center: asked are boxes that have one among its numbers.
  if (center - half != low || center + half != high || half.x * half.y * half.z == 0) throw Unsupported();
  const Geometry geometry(dCreateBox(nullptr, 2 * half.x, 2 * half.y, 2 * half.z));
  dGeomSetPosition(geometry.get(), center.x, center.y, center.z);
  const Vector sides = T(2) * half;
  return meet(call_on("dGeomID geometry = dCreateBox(nullptr, $sides);\ndGeomSetPosition(geometry, $center);",
                      given("sides", sides), given("center", center)),
              geometry.get(),
              peers::segment_past<T>(convert<double>(ray), std::array{dvec3(low), dvec3(high)}));
}

Hit cylinder(const Ray<T>& ray, T rx, T ry, T height, bool capped) {
  if (!capped || rx != ry || height == 0) throw Unsupported();
  const Geometry geometry(dCreateCylinder(nullptr, rx, height));
  dGeomSetPosition(geometry.get(), 0, 0, height / 2);
  const dvec3 center(0, 0, static_cast<double>(height) / 2);
  const double reach = std::hypot(static_cast<double>(rx), center.z);
  const Vector middle(0, 0, height / 2);
  return meet(call_on("dGeomID geometry = dCreateCylinder(nullptr, $radius, $height);\n"
                      "dGeomSetPosition(geometry, $center);",
                      given("radius", rx), given("height", height), given("center", middle)),
              geometry.get(), peers::segment_past<T>(convert<double>(ray), center, reach));
}

/// "The normal vector must have length 1"; n·x = d. The plane is a half-space, met at its boundary.
Hit plane(const Ray<T>& ray, Vector normal, T d) {
  const T length = glm::length(normal);
  const Vector unit = normal / length;
  const T constant = -d / length;
  const Geometry geometry(dCreatePlane(nullptr, unit.x, unit.y, unit.z, constant));
  const Ray<double> wide = convert<double>(ray);
  const double t =
      -(dot(dvec3(normal), wide.origin) + static_cast<double>(d)) / dot(dvec3(normal), wide.direction);
  const dvec3 passed = wide.origin + (std::isfinite(t) ? std::abs(t) : 1.0) * wide.direction;
  const double reach = glm::length(passed - wide.origin) + glm::length(wide.direction);
  return meet(call_on("dGeomID geometry = dCreatePlane(nullptr, $normal, $constant);", given("normal", unit),
                      given("constant", constant)),
              geometry.get(), peers::segment_past<T>(wide, passed, reach, true));
}

/// Its triangle meshes hold doubles here, though OPCODE computes in float.
Hit triangle(const Ray<T>& ray, Vector a, Vector b, Vector c) {
  const std::array<Vector, 3> vertices{a, b, c};
  const std::array<dTriIndex, 3> indices{0, 1, 2};
  const dTriMeshDataID data = dGeomTriMeshDataCreate();
  if constexpr (sizeof(T) == sizeof(double)) {
    dGeomTriMeshDataBuildDouble(data, vertices.data(), sizeof(Vector), 3, indices.data(), 3,
                                3 * sizeof(dTriIndex));
  } else {
    dGeomTriMeshDataBuildSingle(data, vertices.data(), sizeof(Vector), 3, indices.data(), 3,
                                3 * sizeof(dTriIndex));
  }
  Geometry geometry(dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr));
  const auto destroy = [](dTriMeshDataID one) { dGeomTriMeshDataDestroy(one); };
  const std::unique_ptr<dxTriMeshData, decltype(destroy)> owner(data);
  const Geometry shape = std::move(geometry);  // goes before its data
  return meet(call_on(R"($T corners[][3] = {{$a}, {$b}, {$c}};
dTriIndex indices[] = {0, 1, 2};
dTriMeshDataID data = dGeomTriMeshDataCreate();
dGeomTriMeshDataBuildDouble(data, corners, sizeof *corners, 3, indices, 3, sizeof indices);
dGeomID geometry = dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr);)",
                      given("a", a), given("b", b), given("c", c)),
              shape.get(),
              peers::segment_past<T>(convert<double>(ray), std::array{dvec3(a), dvec3(b), dvec3(c)}, true));
}

}  // namespace
}  // namespace rayproof

int main(int count, char** arguments) {
  using namespace rayproof;
  peers::introduce(
      count, arguments,
      {"ODE", RAYPROOF_ODE_VERSION, peers::built_with("-lode"), "https://bitbucket.org/odedevs/ode/issues"});
  dInitODE2(0);
  dAllocateODEDataForThread(dAllocateMaskAll);
  const int status = answer_cases(sphere, box, cylinder, takes<ImplicitPlane>(plane), triangle);
  dCloseODE();
  return status;
}
