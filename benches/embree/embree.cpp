// Single rays and a million triangles through Embree 3, as `benches/mesh.rs` sends them through durer: see run.sh.
// usage: embree DATA ROUNDS [robust] [small]: watertight; on pages of 4 KiB. Times are those of the processor, since other programs may run
// beside it.
#include <embree3/rtcore.h>
#include <sys/prctl.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <limits>
#include <vector>

static double now() {
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return t.tv_sec + 1e-9 * t.tv_nsec;
}

template <class T>
static std::vector<T> take(FILE *f, size_t n) {
  std::vector<T> v(n);
  if (fread(v.data(), sizeof(T), n, f) != n) exit(1);
  return v;
}

// The shortest of some runs.
template <class F>
static double least(int rounds, F run) {
  double best = std::numeric_limits<double>::infinity();
  for (int k = 0; k < rounds; k++) {
    double start = now();
    run();
    best = std::min(best, now() - start);
  }
  return best;
}

int main(int argc, char **argv) {
  if (argc < 3) return 2;
  bool robust = false;
  for (int i = 3; i < argc; i++) {
    robust |= !strcmp(argv[i], "robust");
    if (!strcmp(argv[i], "small")) prctl(PR_SET_THP_DISABLE, 1, 0, 0, 0);
  }
  int rounds = atoi(argv[2]);
  FILE *f = fopen(argv[1], "rb");
  if (!f) return 1;
  auto head = take<uint32_t>(f, 4);
  auto vertices = take<float>(f, 3 * head[0]);
  auto corners = take<uint32_t>(f, 3 * head[1]);
  auto rays = take<float>(f, 6 * (size_t)(head[2] + head[3]));
  fclose(f);

  RTCDevice device = rtcNewDevice("threads=1,set_affinity=0");
  RTCScene scene = nullptr;
  double build = least(rounds, [&] {
    if (scene) rtcReleaseScene(scene);
    scene = rtcNewScene(device);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);
    if (robust) rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry g = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, vertices.data(), 0, 12, head[0]);
    rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, corners.data(), 0, 12, head[1]);
    rtcCommitGeometry(g);
    rtcAttachGeometry(scene, g);
    rtcReleaseGeometry(g);
    rtcCommitScene(scene);
  });
  printf("build: %.3f s\n", build);

  const float far = std::numeric_limits<float>::infinity();
  for (int part = 0; part < 2; part++) {
    const char *name = part ? "incoherent" : "coherent";
    size_t from = part ? head[2] : 0, count = part ? head[3] : head[2], hits = 0;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    if (!part) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    auto each = [&](auto meets) {
      return [&, meets] {
        hits = 0;
        for (const float *r = &rays[6 * from], *end = r + 6 * count; r < end; r += 6)
          hits += meets(RTCRay{r[0], r[1], r[2], 0, r[3], r[4], r[5], 0, far, ~0u, 0, 0});
      };
    };
    double closest = least(rounds, each([&](RTCRay ray) {
      RTCRayHit hit;
      hit.ray = ray;
      hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      rtcIntersect1(scene, &context, &hit);
      return hit.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }));
    printf("%s closest: %.2f M/s (%zu hits)\n", name, count / closest / 1e6, hits);
    double any = least(rounds, each([&](RTCRay ray) {
      rtcOccluded1(scene, &context, &ray);
      return ray.tfar < 0;
    }));
    printf("%s any: %.2f M/s (%zu hits)\n", name, count / any / 1e6, hits);
  }
}
