// Embree as it is used by default, and a second time (PLUMB_EMBREE_ROBUST) with its robust flag.
#include <embree3/rtcore.h>

#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

#include "tools/kernels/kernel_table.h"

namespace plumb::kernels {
namespace {

#ifdef PLUMB_EMBREE_ROBUST
constexpr bool kRobust = true;
#else
constexpr bool kRobust = false;
#endif

/// One for the life of the library. Building with one thread keeps what a process is charged with its own.
RTCDevice device() {
  static const RTCDevice the_device = rtcNewDevice("threads=1,set_affinity=0");
  if (!the_device) throw std::runtime_error("Embree has no device");
  return the_device;
}

void check() {
  if (const RTCError error = rtcGetDeviceError(device()); error != RTC_ERROR_NONE)
    throw std::runtime_error("Embree's error number " + std::to_string(error));
}

/// Embree's robust ranges are closed, its default ones open at t_min and closed at t_max: the largest float below makes
/// them open at both ends.
float end_of_range(double t_max) {
  const auto end = static_cast<float>(t_max);
  return kRobust || std::isinf(end) ? end : std::nextafter(end, -std::numeric_limits<float>::infinity());
}

RTCRay embree_ray(const Ray& ray) {
  return {.org_x = static_cast<float>(ray.origin.x),
          .org_y = static_cast<float>(ray.origin.y),
          .org_z = static_cast<float>(ray.origin.z),
          .tnear = static_cast<float>(ray.t_min),
          .dir_x = static_cast<float>(ray.direction.x),
          .dir_y = static_cast<float>(ray.direction.y),
          .dir_z = static_cast<float>(ray.direction.z),
          .time = 0,
          .tfar = end_of_range(ray.t_max),
          .mask = ~0u,
          .id = 0,
          .flags = 0};
}

class EmbreeKernel {
 public:
  explicit EmbreeKernel(std::span<const plumb_surface> surfaces) : scene_(rtcNewScene(device())) {
    if (kRobust) rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
    for (unsigned i = 0; i < surfaces.size(); ++i) attach(surfaces[i].mesh, i);
    rtcCommitScene(scene_.get());
    check();
  }

  Hit closest(const Ray& ray) const {
    RTCRayHit asked{embree_ray(ray), {}};
    asked.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_.get(), &context, &asked);
    if (asked.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    return {asked.hit.geomID, asked.hit.primID, asked.ray.tfar, asked.hit.u, asked.hit.v};
  }

  bool any(const Ray& ray) const {
    RTCRay asked = embree_ray(ray);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene_.get(), &context, &asked);
    return asked.tfar < asked.tnear;  // minus infinity says so
  }

 private:
  void attach(const plumb_mesh& mesh, unsigned surface) {
    if (mesh.triangle_count == 0) return;
    const RTCGeometry geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* positions = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertex_count));
    auto* triangles = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh.triangle_count));
    check();
    for (size_t i = 0; i < 3 * mesh.vertex_count; ++i) positions[i] = static_cast<float>(mesh.positions[i]);
    std::copy_n(mesh.triangles, 3 * mesh.triangle_count, triangles);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene_.get(), geometry, surface);
    rtcReleaseGeometry(geometry);
  }

  struct Release {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };
  std::unique_ptr<RTCSceneTy, Release> scene_;
};

/// Rays are packed as widely as the instruction set allows, which tells what was chosen.
std::string instruction_set() {
  const auto native = [](RTCDeviceProperty property) { return rtcGetDeviceProperty(device(), property) != 0; };
  if (native(RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED)) return "AVX-512";
  if (native(RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED)) return __builtin_cpu_supports("avx2") ? "AVX2" : "AVX";
  return "SSE";
}

std::string description() {
  const auto version = rtcGetDeviceProperty(device(), RTC_DEVICE_PROPERTY_VERSION);
  return "Embree " + std::to_string(version / 10000) + "." + std::to_string(version / 100 % 100) + "." +
         std::to_string(version % 100) + ", " + instruction_set() + ", rtcIntersect1, " +
         (kRobust ? "RTC_SCENE_FLAG_ROBUST" : "default flags, t_max lowered by one float");
}

constexpr plumb_contract kContract{.precision = PLUMB_FLOAT,
                                   .t_precision = PLUMB_FLOAT,
                                   .culling = PLUMB_CULL_NONE,
                                   .edge_rule = kRobust ? PLUMB_EDGE_WATERTIGHT : PLUMB_EDGE_NONE,
                                   .range = kRobust ? PLUMB_RANGE_CLOSED : PLUMB_RANGE_OPEN,
                                   .inside = PLUMB_INSIDE_HITS_EXIT,
                                   .shapes = PLUMB_MESHES,
                                   .capabilities = PLUMB_THREAD_SAFE,
                                   .largest = 1.8e18};  // beyond it, builds with assertions abort

}  // namespace
}  // namespace plumb::kernels

PLUMB_KERNEL_EXPORT const plumb_kernel* plumb_kernel_v1() {
  using namespace plumb::kernels;
  static const std::string text = description();
  static const plumb_kernel table =
      KernelTable<EmbreeKernel>::make(kRobust ? "embree-robust" : "embree", text.c_str(), kContract);
  return &table;
}
