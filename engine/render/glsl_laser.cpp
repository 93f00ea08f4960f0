#include "engine/render/glsl.h"

namespace brittle::render::glsl {

// A quad that faces the eye, seven times as wide as the beam and longer by as much at both ends: the beam itself burns
// white, and the air about it glows in its colour.
const ProgramSource kLaser = {"laser", R"(
layout(location = 0) in vec4 from;  // point, radius
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 color;
out vec3 vPoint;
flat out vec3 vFrom;
flat out vec3 vTo;
out float vRadius;
flat out vec4 vColor;
void main() {
  bool atEnd = gl_VertexID >= 2;
  vec3 base = atEnd ? to : from.xyz;
  vec3 along = normalize(to - from.xyz + vec3(1e-7));
  vec3 side = cross(along, base - frame.eye.xyz);
  float len = length(side);
  // Far away it stays as wide as a pixel and a half.
  float depth = max(dot(base - frame.eye.xyz, frame.forward.xyz), 0.1);
  vRadius = max(from.w, 1.5 * frame.up.w * depth * frame.picture.w);
  side = len > 1e-6 ? side / len : frame.up.xyz;
  float across = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  vPoint = base + (side * across + along * (atEnd ? 1.0 : -1.0)) * (vRadius * 7.0);
  vFrom = from.xyz;
  vTo = to;
  vColor = vec4(decode(color.rgb), color.a);
  gl_Position = frame.viewProjection * vec4(vPoint, 1.0);
}
)",
                              R"(
in vec3 vPoint;
flat in vec3 vFrom;
flat in vec3 vTo;
in float vRadius;
flat in vec4 vColor;
out vec4 result;
void main() {
  vec3 line = vTo - vFrom;
  float t = clamp(dot(vPoint - vFrom, line) / max(dot(line, line), 1e-9), 0.0, 1.0);
  float off = length(vPoint - vFrom - line * t) / vRadius;
  float core = smoothstep(1.0, 0.25, off);
  float halo = max(1.0 - off / 7.0, 0.0);
  vec3 light = vec3(1.0, 0.93, 0.90) * (core * 0.95) + vColor.rgb * (smoothstep(2.2, 0.4, off) * 0.9 + halo * halo * halo * 0.42);
  result = vec4(light * (vColor.a * clearAt(depthOf(vPoint))), 0.0);
}
)"};

}  // namespace brittle::render::glsl
