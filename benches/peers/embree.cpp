// Embree 3 on the facets and the very rays that `lancer bench --export` writes: how fast it builds, and how fast it
// answers each set of rays in each of its modes. `peers.py` builds and runs this; `embree FACETS RAYS THREADS BUILDS
// PASSES` prints one line of JSON.
//
// Embree gets what is best for it: single rays, packets of 8 and of 16, each with the flag for coherent and for
// incoherent rays; ray packets are neighbours in the picture. As in lancer, filling packets from the list of rays is
// part of the time, what is met is computed and counted, and threads take 4096 rays at a time.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>
#include <thread>
#include <vector>

#include <embree3/rtcore.h>
#include <immintrin.h>

namespace {

constexpr size_t kPiece = 4096;
const char* const kSets[4] = {"primary", "shadow", "reflected", "diffuse"};

struct Ray {
  float origin[3];
  float direction[3];
  float length;
  float met;  // the distance that lancer found; of a shadow ray 0 if it is blocked, else infinite
};

struct Scene {
  std::vector<float> vertices;
  std::vector<uint32_t> facets;
  std::vector<Ray> sets[4];
};

[[noreturn]] void fail(const char* what, const char* path) {
  std::fprintf(stderr, "embree: %s: %s\n", path, what);
  std::exit(1);
}

template <typename T>
void read(std::FILE* file, T* into, size_t count, const char* path) {
  if (std::fread(into, sizeof(T), count, file) != count) fail("the file ends too soon", path);
}

void read_head(std::FILE* file, const char* expected, const char* path) {
  char head[16];
  read(file, head, 16, path);
  if (std::memcmp(head, expected, 16) != 0) fail("this is not the file that is due", path);
}

Scene load(const char* facets_path, const char* rays_path) {
  Scene scene;
  std::FILE* file = std::fopen(facets_path, "rb");
  if (!file) fail("cannot be opened", facets_path);
  read_head(file, "lancer facets 1\n", facets_path);
  uint32_t counts[2];
  read(file, counts, 2, facets_path);
  scene.vertices.resize(size_t(counts[0]) * 3);
  scene.facets.resize(size_t(counts[1]) * 3);
  read(file, scene.vertices.data(), scene.vertices.size(), facets_path);
  read(file, scene.facets.data(), scene.facets.size(), facets_path);
  std::fclose(file);

  file = std::fopen(rays_path, "rb");
  if (!file) fail("cannot be opened", rays_path);
  read_head(file, "lancer rays 1\n\n\n", rays_path);
  for (auto& set : scene.sets) {
    uint64_t count;
    read(file, &count, 1, rays_path);
    set.resize(count);
    read(file, set.data(), count, rays_path);
  }
  std::fclose(file);
  return scene;
}

double seconds() {
  using namespace std::chrono;
  return duration<double>(steady_clock::now().time_since_epoch()).count();
}

// Processor time of all threads of this program so far.
double processor_seconds() {
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

// What things took, time after time: by the clock and in processor time.
struct Times {
  std::vector<double> clock, processor;
  double started = 0, processor_started = 0;
  void start() {
    started = seconds();
    processor_started = processor_seconds();
  }
  void stop() {
    clock.push_back(seconds() - started);
    processor.push_back(processor_seconds() - processor_started);
  }
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const size_t middle = values.size() / 2;
  return values.size() % 2 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

// What a pass found: rays that met something, and how many of them disagree with lancer.
struct Found {
  uint64_t hits = 0;
  uint64_t otherwise = 0;
};

template <int Width>
struct Packet;
template <>
struct Packet<1> {
  using Hit = RTCRayHit;
  using Only = RTCRay;
};
template <>
struct Packet<8> {
  using Hit = RTCRayHit8;
  using Only = RTCRay8;
};
template <>
struct Packet<16> {
  using Hit = RTCRayHit16;
  using Only = RTCRay16;
};

// The lanes of a packet's member; a single ray's member is one lane.
inline float& lane(float& value, int) { return value; }
template <int Width>
inline float& lane(float (&values)[Width], int number) {
  return values[number];
}
inline unsigned& lane(unsigned& value, int) { return value; }
template <int Width>
inline unsigned& lane(unsigned (&values)[Width], int number) {
  return values[number];
}

template <typename Rays>
inline void fill(Rays& rays, const Ray& ray, int number) {
  lane(rays.org_x, number) = ray.origin[0];
  lane(rays.org_y, number) = ray.origin[1];
  lane(rays.org_z, number) = ray.origin[2];
  lane(rays.dir_x, number) = ray.direction[0];
  lane(rays.dir_y, number) = ray.direction[1];
  lane(rays.dir_z, number) = ray.direction[2];
  lane(rays.tnear, number) = 0;
  lane(rays.tfar, number) = ray.length;
  lane(rays.time, number) = 0;
  lane(rays.mask, number) = ~0u;
  lane(rays.id, number) = 0;
  lane(rays.flags, number) = 0;
}

// Whether a distance is not the one that lancer found. In 32 bits it is known to a few units of the last digit of the
// coordinates, here to a ten-thousandth.
inline bool differs(float distance, float met, bool shadow) {
  const bool hit = shadow ? distance < 0 : std::isfinite(distance);
  if (hit != (shadow ? met == 0 : std::isfinite(met))) return true;
  return hit && !shadow && std::fabs(distance - met) > 1e-4f * (1 + std::fabs(met));
}

template <int Width>
Found cast(RTCScene scene, const Ray* rays, size_t count, bool shadow, bool coherent, bool checks) {
  Found found;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  alignas(64) typename Packet<Width>::Hit packet;
  alignas(64) typename Packet<Width>::Only only;
  alignas(64) int valid[16];
  for (size_t first = 0; first < count; first += Width) {
    const int lanes = int(std::min<size_t>(Width, count - first));
    for (int number = 0; number < Width; ++number) {
      valid[number] = number < lanes ? -1 : 0;
      const Ray& ray = rays[first + std::min(number, lanes - 1)];
      if (shadow) {
        fill(only, ray, number);
      } else {
        fill(packet.ray, ray, number);
        lane(packet.hit.geomID, number) = RTC_INVALID_GEOMETRY_ID;
      }
    }
    if constexpr (Width == 1) {
      shadow ? rtcOccluded1(scene, &context, &only) : rtcIntersect1(scene, &context, &packet);
    } else if constexpr (Width == 8) {
      shadow ? rtcOccluded8(valid, scene, &context, &only) : rtcIntersect8(valid, scene, &context, &packet);
    } else {
      shadow ? rtcOccluded16(valid, scene, &context, &only) : rtcIntersect16(valid, scene, &context, &packet);
    }
    for (int number = 0; number < lanes; ++number) {
      const float distance = shadow ? lane(only.tfar, number) : lane(packet.ray.tfar, number);
      found.hits += shadow ? distance < 0 : std::isfinite(distance);
      if (checks) found.otherwise += differs(distance, rays[first + number].met, shadow);
    }
  }
  return found;
}

template <int Width>
Found pass(RTCScene scene, const std::vector<Ray>& rays, bool shadow, bool coherent, unsigned threads, bool checks) {
  std::atomic<size_t> next{0};
  std::vector<Found> found(threads);
  auto work = [&](unsigned thread) {
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
    Found mine;
    for (;;) {
      const size_t first = next.fetch_add(kPiece);
      if (first >= rays.size()) break;
      const Found piece =
          cast<Width>(scene, rays.data() + first, std::min(kPiece, rays.size() - first), shadow, coherent, checks);
      mine.hits += piece.hits;
      mine.otherwise += piece.otherwise;
    }
    found[thread] = mine;
  };
  std::vector<std::thread> helpers;
  for (unsigned thread = 1; thread < threads; ++thread) helpers.emplace_back(work, thread);
  work(0);
  for (auto& helper : helpers) helper.join();
  Found all;
  for (const Found& each : found) {
    all.hits += each.hits;
    all.otherwise += each.otherwise;
  }
  return all;
}

Found pass(RTCScene scene, const std::vector<Ray>& rays, bool shadow, int width, bool coherent, unsigned threads,
           bool checks) {
  switch (width) {
    case 1: return pass<1>(scene, rays, shadow, coherent, threads, checks);
    case 8: return pass<8>(scene, rays, shadow, coherent, threads, checks);
    default: return pass<16>(scene, rays, shadow, coherent, threads, checks);
  }
}

std::atomic<int64_t> memory{0};

bool count_memory(void*, ssize_t bytes, bool) {
  memory += bytes;
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 6) {
    std::fprintf(stderr, "embree FACETS RAYS THREADS BUILDS PASSES\n");
    return 2;
  }
  const Scene loaded = load(argv[1], argv[2]);
  const unsigned threads = std::max(1, std::atoi(argv[3]));
  const int builds = std::max(1, std::atoi(argv[4])), passes = std::max(1, std::atoi(argv[5]));

  RTCDevice device = rtcNewDevice(("threads=" + std::to_string(threads)).c_str());
  if (!device) fail("no device", "embree");
  rtcSetDeviceMemoryMonitorFunction(device, count_memory, nullptr);

  RTCScene scene = nullptr;
  Times times;
  int64_t bytes = 0;
  for (int build = 0; build < builds; ++build) {
    if (scene) rtcReleaseScene(scene);
    scene = rtcNewScene(device);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_MEDIUM);
    void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12,
                                             loaded.vertices.size() / 3);
    void* facets =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, loaded.facets.size() / 3);
    std::memcpy(vertices, loaded.vertices.data(), loaded.vertices.size() * 4);
    std::memcpy(facets, loaded.facets.data(), loaded.facets.size() * 4);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    const int64_t before = memory;
    times.start();
    rtcCommitScene(scene);
    times.stop();
    bytes = memory - before;
  }
  if (rtcGetDeviceError(device) != RTC_ERROR_NONE) fail("building failed", "embree");

  std::printf("{\"version\":\"%d.%d.%d\",\"threads\":%u,\"facets\":%zu,\"build\":{\"seconds\":%.6f,\"processor\":%.6f},"
              "\"bytes\":%lld",
              int(rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_VERSION_MAJOR)),
              int(rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_VERSION_MINOR)),
              int(rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_VERSION_PATCH)), threads, loaded.facets.size() / 3,
              median(times.clock), median(times.processor), static_cast<long long>(bytes));
  for (int set = 0; set < 4; ++set) {
    const std::vector<Ray>& rays = loaded.sets[set];
    const bool shadow = set == 1;
    std::printf(",\"%s\":{\"rays\":%zu,\"modes\":[", kSets[set], rays.size());
    bool first = true;
    for (const int width : {1, 8, 16}) {
      for (const bool coherent : {true, false}) {
        // once before, as lancer does; whether both found the same is looked at here, not in what is timed
        const Found found = pass(scene, rays, shadow, width, coherent, threads, true);
        Times taken;
        for (int number = 0; number < passes; ++number) {
          taken.start();
          pass(scene, rays, shadow, width, coherent, threads, false);
          taken.stop();
        }
        std::printf("%s{\"width\":%d,\"coherent\":%s,\"seconds\":%.6f,\"processor\":%.6f,\"hits\":%llu,"
                    "\"otherwise\":%llu}",
                    first ? "" : ",", width, coherent ? "true" : "false", median(taken.clock), median(taken.processor),
                    static_cast<unsigned long long>(found.hits), static_cast<unsigned long long>(found.otherwise));
        first = false;
      }
    }
    std::printf("]}");
  }
  std::printf("}\n");
  rtcReleaseScene(scene);
  rtcReleaseDevice(device);
  return 0;
}
