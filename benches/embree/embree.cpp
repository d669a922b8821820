// Single rays and a million triangles through Embree 3, as `benches/mesh.rs` sends them through durer: see run.sh.
// usage: embree DATA [robust]. Times are those of the processor, since other programs may run beside it.
#include <embree3/rtcore.h>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <vector>
#include <ctime>
struct Clock { using time_point=double; static double now(){ timespec t; clock_gettime(CLOCK_PROCESS_CPUTIME_ID,&t); return t.tv_sec+1e-9*t.tv_nsec; } };
static double since(Clock::time_point t) { return Clock::now() - t; }
template <class T> static std::vector<T> take(FILE *f, size_t n) { std::vector<T> v(n); if (fread(v.data(), sizeof(T), n, f) != n) exit(1); return v; }
int main(int argc, char **argv) {
  FILE *f = fopen(argv[1], "rb");
  auto head = take<uint32_t>(f, 4);
  auto vertices = take<float>(f, 3 * head[0]);
  auto corners = take<uint32_t>(f, 3 * head[1]);
  auto rays = take<float>(f, 6 * (size_t)(head[2] + head[3]));
  RTCDevice device = rtcNewDevice("threads=1,set_affinity=0");
  RTCScene scene = nullptr;
  double best = 1e9;
  for (int k = 0; k < 3; k++) {
    auto t = Clock::now();
    scene = rtcNewScene(device);
    if (argc > 2) rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry g = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, vertices.data(), 0, 12, head[0]);
    rtcSetSharedGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, corners.data(), 0, 12, head[1]);
    rtcCommitGeometry(g); rtcAttachGeometry(scene, g); rtcReleaseGeometry(g); rtcCommitScene(scene);
    best = std::min(best, since(t));
  }
  printf("build %.3f s\n", best);
  for (int part = 0; part < 2; part++) {
    size_t from = part ? head[2] : 0, count = part ? head[3] : head[2];
    double b1 = 1e9, b2 = 1e9, sum = 0; size_t h1 = 0, h2 = 0;
    for (int k = 0; k < 3; k++) {
      RTCIntersectContext c; rtcInitIntersectContext(&c);
      if (!part) c.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
      auto t = Clock::now(); h1 = 0; sum = 0;
      for (size_t i = from; i < from + count; i++) {
        const float *r = &rays[6 * i];
        RTCRayHit h; h.ray = {r[0], r[1], r[2], 0, r[3], r[4], r[5], 0, INFINITY, ~0u, 0, 0}; h.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene, &c, &h);
        if (h.hit.geomID != RTC_INVALID_GEOMETRY_ID) { h1++; sum += h.ray.tfar; }
      }
      b1 = std::min(b1, since(t));
      t = Clock::now(); h2 = 0;
      for (size_t i = from; i < from + count; i++) {
        const float *r = &rays[6 * i];
        RTCRay h = {r[0], r[1], r[2], 0, r[3], r[4], r[5], 0, INFINITY, ~0u, 0, 0};
        rtcOccluded1(scene, &c, &h);
        h2 += h.tfar < 0;
      }
      b2 = std::min(b2, since(t));
    }
    printf("%s: closest %.2f M/s (%zu hits, sum %.6f), any %.2f M/s (%zu)\n", part ? "incoherent" : "coherent", count / b1 / 1e6, h1, sum, count / b2 / 1e6, h2);
  }
}
