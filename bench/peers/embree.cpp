// Embree as Debian builds it: by default, with its robust flag and with its high build quality by single-ray calls, and
// by default in batches. Its ranges are taken as they are given.
#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "bench/peers/roster.h"

namespace plumb::bench {
namespace {

RTCRay ray_of(const FloatRay& ray) {
  return {.org_x = ray.origin[0],
          .org_y = ray.origin[1],
          .org_z = ray.origin[2],
          .tnear = ray.t_min,
          .dir_x = ray.direction[0],
          .dir_y = ray.direction[1],
          .dir_z = ray.direction[2],
          .time = 0,
          .tfar = ray.t_max,
          .mask = ~0u,
          .id = 0,
          .flags = 0};
}

RTCRayHit query_of(const FloatRay& ray) {
  RTCRayHit query;
  query.ray = ray_of(ray);
  query.hit.geomID = query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  return query;
}

Found found_by(const RTCRayHit& query) {
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  return {query.ray.tfar, query.hit.primID};
}

/// Minus infinity says so.
bool is_blocked(const RTCRay& ray) { return ray.tfar < 0; }

RTCIntersectContext context(RTCIntersectContextFlags flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT) {
  RTCIntersectContext made;
  rtcInitIntersectContext(&made);
  made.flags = flags;
  return made;
}

bool add_bytes(void* total, ssize_t bytes, bool) {
  *static_cast<ssize_t*>(total) += bytes;
  return true;
}

struct ReleaseDevice {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};

/// A mesh in a device of its own, which counts what it allocates: its buffers of vertices and indices, and what the
/// hierarchy keeps after the build.
class EmbreeScene {
 public:
  EmbreeScene(const TriangleMesh& mesh, int threads, RTCSceneFlags flags, RTCBuildQuality quality, BuildCost& cost)
      : device_(rtcNewDevice(("threads=" + std::to_string(threads) + ",set_affinity=0").c_str())) {
    if (!device_) throw std::runtime_error("Embree has no device");
    rtcSetDeviceMemoryMonitorFunction(device_.get(), add_bytes, &bytes_);
    scene_.reset(rtcNewScene(device_.get()));
    rtcSetSceneFlags(scene_.get(), flags);
    rtcSetSceneBuildQuality(scene_.get(), quality);
    const RTCGeometry geometry = filled_geometry(mesh);
    rtcSetGeometryBuildQuality(geometry, quality);
    timed_build(cost, [&] {
      rtcCommitGeometry(geometry);
      rtcAttachGeometryByID(scene_.get(), geometry, 0);
      rtcCommitScene(scene_.get());
    });
    rtcReleaseGeometry(geometry);
    check();
  }
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  RTCScene get() const { return scene_.get(); }
  std::size_t bytes() const { return static_cast<std::size_t>(bytes_); }

 private:
  RTCGeometry filled_geometry(const TriangleMesh& mesh) const {
    const RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* positions = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.positions.size()));
    auto* triangles = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh.triangles.size()));
    check();
    for (const Point3& p : mesh.positions)
      for (int axis = 0; axis < 3; ++axis) *positions++ = static_cast<float>(p[axis]);
    std::memcpy(triangles, mesh.triangles.data(), mesh.triangles.size() * sizeof(mesh.triangles[0]));
    return geometry;
  }

  void check() const {
    if (const RTCError error = rtcGetDeviceError(device_.get()); error != RTC_ERROR_NONE)
      throw std::runtime_error("Embree's error number " + std::to_string(error));
  }

  ssize_t bytes_ = 0;
  std::unique_ptr<RTCDeviceTy, ReleaseDevice> device_;
  std::unique_ptr<RTCSceneTy, ReleaseScene> scene_;
};

class EmbreePeer : public PeerLoops<EmbreePeer> {
 public:
  template <class... Arguments>
  explicit EmbreePeer(Arguments&&... arguments) : scene_(std::forward<Arguments>(arguments)...) {}

  Found closest_of(const RaySet& set, std::size_t ray) const override {
    RTCRayHit query = query_of(set.floats[ray]);
    RTCIntersectContext asked = context();
    rtcIntersect1(scene_.get(), &asked, &query);
    return found_by(query);
  }

  bool any_of(const RaySet& set, std::size_t ray) const override {
    RTCRay query = ray_of(set.floats[ray]);
    RTCIntersectContext asked = context();
    rtcOccluded1(scene_.get(), &asked, &query);
    return is_blocked(query);
  }

  std::size_t bytes() const override { return scene_.bytes(); }

 private:
  EmbreeScene scene_;
};

/// By rtcIntersect1M and rtcOccluded1M. A caller with many rays at hand writes them into such a batch.
template <RTCIntersectContextFlags kFlags>
class EmbreeBatchPeer : public Peer {
 public:
  template <class... Arguments>
  explicit EmbreeBatchPeer(Arguments&&... arguments) : scene_(std::forward<Arguments>(arguments)...) {}

  Tally closest(const RaySet& set, const Slice& slice) const override {
    Tally tally;
    std::array<RTCRayHit, kBatch> batch;
    in_batches(slice, [&](std::size_t first, std::size_t count) {
      for (std::size_t i = 0; i < count; ++i) batch[i] = query_of(set.floats[first + i * slice.step]);
      RTCIntersectContext asked = context(kFlags);
      rtcIntersect1M(scene_.get(), &asked, batch.data(), static_cast<unsigned>(count), sizeof(RTCRayHit));
      for (std::size_t i = 0; i < count; ++i) {
        const Found found = found_by(batch[i]);
        tally.hits += found.hit();
        tally.triangles += found.triangle;
      }
    });
    return tally;
  }

  Tally any(const RaySet& set, const Slice& slice) const override {
    Tally tally;
    std::array<RTCRay, kBatch> batch;
    in_batches(slice, [&](std::size_t first, std::size_t count) {
      for (std::size_t i = 0; i < count; ++i) batch[i] = ray_of(set.floats[first + i * slice.step]);
      RTCIntersectContext asked = context(kFlags);
      rtcOccluded1M(scene_.get(), &asked, batch.data(), static_cast<unsigned>(count), sizeof(RTCRay));
      for (std::size_t i = 0; i < count; ++i) tally.hits += is_blocked(batch[i]);
    });
    return tally;
  }

  Found closest_of(const RaySet& set, std::size_t ray) const override {
    RTCRayHit query = query_of(set.floats[ray]);
    RTCIntersectContext asked = context(kFlags);
    rtcIntersect1M(scene_.get(), &asked, &query, 1, sizeof query);
    return found_by(query);
  }
  bool any_of(const RaySet& set, std::size_t ray) const override {
    RTCRay query = ray_of(set.floats[ray]);
    RTCIntersectContext asked = context(kFlags);
    rtcOccluded1M(scene_.get(), &asked, &query, 1, sizeof query);
    return is_blocked(query);
  }
  std::size_t bytes() const override { return scene_.bytes(); }

 private:
  static constexpr std::size_t kBatch = 256;

  template <class Ask>
  static void in_batches(const Slice& slice, const Ask& ask) {
    for (std::size_t done = 0; done < slice.count(); done += kBatch)
      ask(slice.begin + done * slice.step, std::min(kBatch, slice.count() - done));
  }

  EmbreeScene scene_;
};

template <class Kind, RTCSceneFlags kFlags, RTCBuildQuality kQuality>
std::unique_ptr<Peer> build(const std::shared_ptr<const TriangleMesh>& mesh, int threads, BuildCost& cost) {
  return std::make_unique<Kind>(*mesh, threads, kFlags, kQuality, cost);
}

/// Rays are packed as widely as the instruction set allows, which tells what was chosen.
std::string version_and_instructions() {
  const std::unique_ptr<RTCDeviceTy, ReleaseDevice> device(rtcNewDevice("threads=1,set_affinity=0"));
  const auto property = [&](RTCDeviceProperty asked) { return rtcGetDeviceProperty(device.get(), asked); };
  const bool wide = property(RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED) != 0;
  const char* instructions = property(RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED) != 0 ? "AVX-512"
                             : wide && __builtin_cpu_supports("avx2")                  ? "AVX2"
                             : wide                                                    ? "AVX"
                                                                                       : "SSE";
  const auto version = [&](RTCDeviceProperty part) { return std::to_string(property(part)); };
  return "Embree " + version(RTC_DEVICE_PROPERTY_VERSION_MAJOR) + "." + version(RTC_DEVICE_PROPERTY_VERSION_MINOR) +
         "." + version(RTC_DEVICE_PROPERTY_VERSION_PATCH) + " as Debian builds it, " + instructions;
}

}  // namespace

std::vector<PeerKind> embree_peers() {
  constexpr auto kNone = RTC_SCENE_FLAG_NONE;
  constexpr auto kMedium = RTC_BUILD_QUALITY_MEDIUM;
  using Incoherent = EmbreeBatchPeer<RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT>;
  using Coherent = EmbreeBatchPeer<RTC_INTERSECT_CONTEXT_FLAG_COHERENT>;
  const std::string embree = version_and_instructions();
  return {{.name = "embree",
           .description = embree + ", default flags, rtcIntersect1 and rtcOccluded1",
           .build = build<EmbreePeer, kNone, kMedium>},
          {.name = "robust",
           .description = embree + ", RTC_SCENE_FLAG_ROBUST",
           .build = build<EmbreePeer, RTC_SCENE_FLAG_ROBUST, kMedium>},
          {.name = "high",
           .description = embree + ", RTC_BUILD_QUALITY_HIGH (spatial splits)",
           .build = build<EmbreePeer, kNone, RTC_BUILD_QUALITY_HIGH>},
          {.name = "1M",
           .description = embree + ", rtcIntersect1M and rtcOccluded1M of 256 rays",
           .build = build<Incoherent, kNone, kMedium>,
           .batches = true},
          {.name = "1M-coherent",
           .description = embree + ", the same with RTC_INTERSECT_CONTEXT_FLAG_COHERENT",
           .build = build<Coherent, kNone, kMedium>,
           .batches = true}};
}

}  // namespace plumb::bench
