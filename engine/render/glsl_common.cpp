#include "engine/render/glsl.h"

namespace brittle::render::glsl {

// FrameBlock mirrors FrameUniforms, MaterialBlock mirrors MaterialUniforms (uniforms.h).
const char* const kHeader = R"(#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;

layout(std140) uniform FrameBlock {
  mat4 viewProjection;
  vec4 right;      // w: tangent of half the horizontal field of view
  vec4 up;         // w: the same, vertical
  vec4 forward;    // w: near plane
  vec4 eye;        // w: far plane
  vec4 fogBottom;  // sRGB-encoded; w: start of the fog
  vec4 fogTop;     // sRGB-encoded; w: 1 / (end - start)
  vec4 toLight;    // unit; w: ambient share
  vec4 lightColor; // linear; w: opacity of the shadows of spheres
  vec4 picture;    // width, height, 1 / width, 1 / height
  vec4 low;        // linear fog colours, clamped: what mirrors show far away, below and above
  vec4 high;
  vec4 room;       // what mirrors show near by: the sides of a long box, low x, low y, high x, high y
  vec4 lampColor;  // linear; w: number of lamps
  vec4 walls[4];   // linear: left, right, floor, ceiling
  vec4 lampPlace[8];  // centre, light
  vec4 lampForm[8];   // half extents
  vec4 mirror;        // height of the mirror floor, 1 if there is one
} frame;

layout(std140) uniform MaterialBlock {
  vec4 surface[32];  // linear colour, metalness
  vec4 finish[32];   // gloss, clarity, edge
} materials;

// The polynomial stays within 0.002 of the exact curve on [0, 1].
vec3 decode(vec3 c) { return c * (c * (c * 0.305306011 + 0.682171111) + 0.012522878); }
vec3 rotate(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }
)";

const char* const kVertexCommon = R"(
uniform sampler2D bodyTexture;    // two texels a body: position, quaternion
uniform usampler2D shapeTexture;  // a texel a mesh slot: body, material, tint

struct Pose { vec3 position; vec4 rotation; };
Pose fetchBody(uint body) {
  int texel = int(body) * 2;
  ivec2 at = ivec2(texel & 1023, texel >> 10);
  return Pose(texelFetch(bodyTexture, at, 0).xyz, texelFetch(bodyTexture, at + ivec2(1, 0), 0));
}
uvec4 fetchShape(uint slot) { return texelFetch(shapeTexture, ivec2(int(slot) & 1023, int(slot) >> 10), 0); }
vec4 unpackColor(uint c) { return vec4(c & 255u, (c >> 8) & 255u, (c >> 16) & 255u, c >> 24) / 255.0; }
)";

const char* const kFragmentCommon = R"(
// Value noise on a grid of 1, from 0 to 1.
float chance(vec2 cell) {
  vec3 p = fract(vec3(cell.xyx) * 0.1031);
  p += dot(p, p.yzx + 33.33);
  return fract((p.x + p.y) * p.z);
}
float noise(vec2 p) {
  vec2 cell = floor(p), f = fract(p);
  f = f * f * (3.0 - 2.0 * f);
  return mix(mix(chance(cell), chance(cell + vec2(1.0, 0.0)), f.x),
             mix(chance(cell + vec2(0.0, 1.0)), chance(cell + vec2(1.0, 1.0)), f.x), f.y);
}
vec3 fogColor() {
  vec3 c = mix(frame.fogBottom.rgb, frame.fogTop.rgb, gl_FragCoord.y * frame.picture.w);
  return decode(clamp(c, 0.0, 1.0));
}
float depthOf(vec3 point) { return dot(point - frame.eye.xyz, frame.forward.xyz); }
float fogAt(float depth) { return clamp((depth - frame.fogBottom.w) * frame.fogTop.w, 0.0, 1.0); }

// How much of something translucent is drawn now. Where there is depth of field it is drawn twice: what is far away before the blur,
// blurred as what is behind it, what is near after it, and what is between in both, so that it comes into focus smoothly.
uniform vec4 focusPart;  // sharp up to here, 1 / range, share of what is near, share of what is far
float partAt(float depth) {
  return focusPart.z + (focusPart.w - focusPart.z) * smoothstep(0.0, 0.5, (depth - focusPart.x) * focusPart.y);
}
float clearAt(float depth) { return (1.0 - fogAt(depth)) * partAt(depth); }
vec3 withFog(vec3 color, vec3 point) { return mix(color, fogColor(), fogAt(depthOf(point))); }

// What a dull mirror shows in direction r: the fog's colours, dim below.
vec3 surroundings(vec3 r) { return mix(frame.low.rgb * 0.35, frame.high.rgb * 0.85, smoothstep(-0.25, 0.55, r.y)); }

// What a mirror at `point` shows in direction r: the side of the room it looks at, its lamps, and the fog before them. `soft` [m] blurs.
// Only the nearest `lamps` are looked for.
vec3 environment(vec3 point, vec3 r, float soft, int lamps) {
  bvec2 up = greaterThan(r.xy, vec2(0.0));
  vec2 side = vec2(up.x ? frame.room.z : frame.room.x, up.y ? frame.room.w : frame.room.y);
  vec2 ways = max((side - point.xy) / (abs(r.xy) + 1e-4) * (vec2(up) * 2.0 - 1.0), 0.0);
  float way = min(ways.x, ways.y);
  vec3 hit = point + r * way;
  vec3 across = up.x ? frame.walls[1].rgb : frame.walls[0].rgb;
  vec3 along = up.y ? frame.walls[3].rgb : frame.walls[2].rgb;
  vec3 c = mix(across, along, smoothstep(-soft, soft, ways.x - ways.y));
  c *= mix(0.55, 1.3, smoothstep(-0.7, 0.7, r.y));  // mirrors look better in a room with more contrast than ours
  vec2 corner = min(hit.xy - frame.room.xy, frame.room.zw - hit.xy);
  c *= 0.62 + 0.38 * smoothstep(0.0, 1.4, max(corner.x, corner.y));
  for (int i = 0; i < min(lamps, int(frame.lampColor.w)); ++i) {
    vec3 off = max(abs(hit - frame.lampPlace[i].xyz) - frame.lampForm[i].xyz, 0.0);
    float far = dot(off, off);
    c += frame.lampColor.rgb * (frame.lampPlace[i].w * (smoothstep(soft * soft, 0.0, far) * 1.5 + 0.18 / (0.5 + far)));
  }
  float fog = fogAt(depthOf(point) + way);
  return mix(c, mix(frame.low.rgb, frame.high.rgb, clamp(0.5 + 0.6 * r.y, 0.0, 1.0)), fog);
}

float schlick(float cosine, float base) {
  float m = 1.0 - clamp(cosine, 0.0, 1.0);
  float m2 = m * m;
  return base + (1.0 - base) * m2 * m2 * m;
}

// Towards the eye, unit.
vec3 toEye(vec3 point) { return normalize(frame.eye.xyz - point); }

// The interpolated normal where the mesh has one (w > 0), else the face's from derivatives; turned to the eye. A face that lies more than
// 60 degrees off its interpolated normal is the end of something round, whose corners have the normals of its side: flat.
vec3 surfaceNormal(vec4 normal, vec3 point) {
  vec3 relative = point - frame.eye.xyz;
  vec3 n = normalize(cross(dFdx(relative), dFdy(relative)));
  vec3 smoothed = normalize(normal.xyz + vec3(1e-7));
  if (normal.w > 0.5 && abs(dot(smoothed, n)) > 0.5) n = smoothed;
  return dot(n, relative) > 0.0 ? -n : n;
}

// Light reflected to the eye by an opaque surface; `open` in [0, 1] is how much of the surroundings it sees.
vec3 shade(vec3 albedo, vec3 point, vec3 n, float metalness, float gloss, float open) {
  vec3 v = toEye(point);
  vec3 r = reflect(-v, n);
  float facing = max(dot(n, v), 0.0);
  float lambert = max(dot(n, frame.toLight.xyz), 0.0);
  float sky = 0.75 + 0.25 * n.y;
  vec3 diffuse = albedo * (frame.toLight.w * sky + (1.0 - frame.toLight.w) * lambert * frame.lightColor.rgb);
  float fresnel = schlick(facing, 0.04) * (0.2 + 0.8 * gloss);
  vec3 mirror = environment(point, normalize(mix(n, r, 0.4 + 0.6 * gloss)), mix(2.5, 0.08, gloss), 8);
  vec3 highlight = frame.lightColor.rgb * (pow(max(dot(r, frame.toLight.xyz), 0.0), mix(8.0, 300.0, gloss * gloss)) * (0.15 + 1.6 * gloss));
  vec3 plastic = diffuse + (mirror + highlight) * fresnel;
  mirror *= 0.45 + 1.3 * dot(mirror, vec3(0.3, 0.5, 0.2));  // polished steel shows bright things brighter
  vec3 metal = mix(albedo, vec3(1.0), schlick(facing, 0.0)) * (mirror + highlight * 0.7) + albedo * 0.04;
  return mix(plastic, metal, metalness) * open;
}
)";

// One triangle that covers the picture.
const char* const kScreenVertex = R"(
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(corner, 1.0, 1.0);
}
)";

}  // namespace brittle::render::glsl
