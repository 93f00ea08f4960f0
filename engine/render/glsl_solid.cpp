#include "engine/render/glsl.h"

namespace brittle::render::glsl {

const ProgramSource kRoom = {"room", R"(
layout(location = 0) in vec3 point;
layout(location = 1) in vec2 tile;
layout(location = 2) in vec4 color;
uniform vec4 offset;
out vec3 vPoint;
out vec2 vTile;
out vec4 vColor;
void main() {
  vPoint = point + offset.xyz;
  vTile = tile;
  vColor = color;
  gl_Position = frame.viewProjection * vec4(vPoint, 1.0);
}
)",
                             R"(
uniform sampler2D tileTexture;
uniform vec4 offset;  // w: 1 where it reflects
in vec3 vPoint;
in vec2 vTile;
in vec4 vColor;
out vec4 result;
void main() {
  float closed = 1.0 - vColor.a;
  float open = 1.0 - closed * closed;
  vec3 albedo = decode(clamp(vColor.rgb * 2.0 * texture(tileTexture, vTile).r, 0.0, 1.0));
  vec3 n = surfaceNormal(vec4(0.0), vPoint);
  vec3 v = toEye(vPoint);
  // Light on faces is baked into the colours; what does not see the room's light still sees its colour.
  vec3 color = albedo * mix(frame.low.rgb * 0.22 + 0.03, vec3(1.0), open);
  // A mirror floor lets the room that is drawn upside down below it through; other polished faces show its colours.
  bool isMirror = offset.w > 0.5 && n.y > 0.5 && abs(vPoint.y - frame.mirror.x) < 0.02 && frame.mirror.y > 0.5;
  float polish = schlick(dot(n, v), offset.w > 0.5 ? 0.10 : 0.04) * (offset.w > 0.5 ? 1.0 : n.y > 0.5 ? 0.6 : 0.3) * open;
  float through = isMirror ? polish : 0.0;
  color = color * (1.0 - offset.w * polish) + (isMirror ? vec3(0.0) : surroundings(reflect(-v, n)) * polish);
  float clear = 1.0 - fogAt(depthOf(vPoint));
  through *= clear;
  result = vec4(color * clear + fogColor() * (1.0 - clear), 1.0 - through);
}
)"};

// The mesh pool's vertices: opaque and glass convexes share this vertex stage.
static constexpr const char* kConvexVertex = R"(
layout(location = 0) in vec3 point;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec4 color;
layout(location = 3) in uint slot;
out vec3 vPoint;
out vec4 vNormal;
out vec4 vColor;
flat out int vMaterial;
void main() {
  uvec4 shape = fetchShape(slot);
  Pose pose = fetchBody(shape.x);
  vPoint = rotate(pose.rotation, point) + pose.position;
  float has = normal == vec4(0.0) ? 0.0 : 1.0;
  vNormal = vec4(rotate(pose.rotation, normal.xyz), has);
  vColor = color * unpackColor(shape.z);
  vMaterial = int(shape.y);
  gl_Position = frame.viewProjection * vec4(vPoint, 1.0);
}
)";

const ProgramSource kSolid = {"solid", kConvexVertex, R"(
in vec3 vPoint;
in vec4 vNormal;
in vec4 vColor;
flat in int vMaterial;
out vec4 result;
void main() {
  vec4 surface = materials.surface[vMaterial];
  vec3 n = surfaceNormal(vNormal, vPoint);
  vec3 color = shade(surface.rgb * decode(vColor.rgb), vPoint, n, surface.a, materials.finish[vMaterial].x, 1.0);
  result = vec4(withFog(color, vPoint), 1.0);
}
)"};

// Blended as result + behind * (1 - result.a). What passes through is split: the part every channel shares (`even`)
// lets glass drawn before show through; the rest, and all of it where the surface bends light visibly, is looked up in
// the opaque picture.
const ProgramSource kGlass = {"glass", kConvexVertex, R"(
uniform sampler2D colorTexture;  // the opaque picture
uniform sampler2D depthTexture;
uniform vec4 bend;               // x: strength of refraction [picture heights], 0 switches the look-up off; y: 1 where it broke
in vec3 vPoint;
in vec4 vNormal;
in vec4 vColor;
flat in int vMaterial;
out vec4 result;
void main() {
  vec4 surface = materials.surface[vMaterial];
  vec4 finish = materials.finish[vMaterial];
  vec3 n = surfaceNormal(vNormal, vPoint);
  float clear = clearAt(depthOf(vPoint));
  if (clear <= 0.0) discard;  // nothing of it is seen, or all in the other part
  vec3 v = toEye(vPoint);
  float facing = clamp(dot(n, v), 0.0, 1.0);
  float fresnel = schlick(facing, 0.07);
  vec3 tint = surface.rgb * decode(vColor.rgb);
  vec3 r = reflect(-v, n);
  float cut = bend.y;

  float path = 1.0 / (0.35 + 0.65 * facing);  // a slanted ray stays in the glass for longer
  vec3 through = tint * mix(vec3(1.0), tint, min((path - 1.0) * 0.8 + cut, 1.5)) * finish.y * (1.0 - fresnel);
  float sharp = pow(max(dot(r, frame.toLight.xyz), 0.0), mix(30.0, 420.0, finish.x));
  float glint = smoothstep(0.35, 0.95, sin(11.0 * r.x + 6.0 * r.y));  // window light, in slanted bands
  vec3 mirror = environment(vPoint, r, 0.15, 4) * fresnel;
  mirror += frame.high.rgb * (glint * (0.08 + 0.6 * fresnel) * finish.x) + frame.lightColor.rgb * (sharp * finish.x * 1.5);
  // A broken face gathers the light inside the glass: pale where one looks along it, clear where one looks through it.
  float grazing = cut * (1.0 - facing * facing);
  vec3 pale = mix(tint, vec3(1.0), 0.45) * (0.35 + 0.65 * frame.high.rgb);
  float gathered = (0.30 + 0.40 * abs(n.x) + 0.40 * max(n.y, 0.0)) * (0.25 + 0.75 * grazing);
  float rim = (1.0 - facing) * (1.0 - facing);
  // Coloured glass catches the room's light in its depth: it is lit by it, not only darker than what is behind.
  float colored = 1.0 - min(tint.r, min(tint.g, tint.b)) / max(max(tint.r, max(tint.g, tint.b)), 1e-3);
  float lit = frame.toLight.w * (1.0 - finish.y) * 0.9 + 0.16 * rim + 0.45 * colored * colored * frame.high.g;
  vec3 body = tint * lit * (0.75 + 0.25 * n.y);
  vec3 color = mirror + mix(body, pale * gathered, cut);
  through *= 1.0 - 0.55 * grazing;

  float even = min(through.r, min(through.g, through.b));
  if (bend.x > 0.0) {
    vec2 tilt = vec2(dot(n, frame.right.xyz), dot(n, frame.up.xyz));
    float bent = smoothstep(0.12, 0.6, length(tilt)) * 0.9;
    vec2 at = gl_FragCoord.xy * frame.picture.zw - tilt * bend.x * vec2(frame.picture.y * frame.picture.z, 1.0);
    // What stands before the glass is not seen through it.
    if (texture(depthTexture, at).r < gl_FragCoord.z) at = gl_FragCoord.xy * frame.picture.zw;
    even *= 1.0 - bent;
    color += texture(colorTexture, at).rgb * (through - even);
  } else {
    color += tint * (dot(through - even, vec3(0.333)) * 0.5);
  }
  result = vec4(color, 1.0 - even) * clear;
}
)"};

const ProgramSource kSphere = {"sphere", R"(
layout(location = 0) in vec3 point;     // on the unit sphere
layout(location = 1) in vec4 place;     // centre, radius
layout(location = 2) in vec4 rotation;
layout(location = 3) in vec4 color;
layout(location = 4) in uint material;
out vec3 vPoint;
out vec3 vNormal;
out vec3 vLocal;
flat out vec3 vColor;
flat out int vMaterial;
void main() {
  vLocal = point;
  vNormal = rotate(rotation, point);
  vPoint = place.xyz + place.w * vNormal;
  vColor = decode(color.rgb);
  vMaterial = int(material);
  gl_Position = frame.viewProjection * vec4(vPoint, 1.0);
}
)",
                               R"(
in vec3 vPoint;
in vec3 vNormal;
in vec3 vLocal;
flat in vec3 vColor;
flat in int vMaterial;
out vec4 result;
void main() {
  vec3 n = normalize(vNormal);
  vec4 surface = materials.surface[vMaterial];
  // A thin groove shows how it turns.
  float groove = abs(normalize(vLocal).y);
  float soft = fwidth(groove) + 0.004;
  float engraved = smoothstep(0.022 + soft, 0.022 - soft, groove);
  float open = (0.62 + 0.38 * smoothstep(-0.9, 0.3, n.y)) * (1.0 - 0.35 * engraved);
  vec3 color = shade(surface.rgb * vColor, vPoint, n, surface.a, materials.finish[vMaterial].x, open);
  result = vec4(withFog(color, vPoint), 1.0);
}
)"};

// A tetrahedron that turns as it moves: its attitude is a function of where it is, so a resting one rests. What tells
// it from others is its radius, which stays with it whatever its place in the list; and 64 m along z, the step of the
// origin's shifts, are 71 whole turns.
const ProgramSource kCrumb = {"crumb", R"(
layout(location = 1) in vec4 place;  // centre, radius
layout(location = 2) in vec4 color;
out vec3 vPoint;
flat out vec3 vColor;
const vec3 corners[4] = vec3[4](vec3(1, 1, 1), vec3(1, -1, -1), vec3(-1, 1, -1), vec3(-1, -1, 1));
const int faces[12] = int[12](0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2);
void main() {
  float own = fract(place.w * 7919.0) * 6.2831853;
  float turn = dot(place.xyz, vec3(9.0, 13.0, 6.9703345)) + own * 2.4;
  vec3 axis = normalize(vec3(sin(own), 0.6, cos(own * 1.7)));
  vec4 q = vec4(axis * sin(turn * 0.5), cos(turn * 0.5));
  vPoint = place.xyz + rotate(q, corners[faces[gl_VertexID]]) * (place.w * 0.8);
  vColor = decode(color.rgb);
  gl_Position = frame.viewProjection * vec4(vPoint, 1.0);
}
)",
                              R"(
in vec3 vPoint;
flat in vec3 vColor;
out vec4 result;
void main() {
  vec3 n = surfaceNormal(vec4(0.0), vPoint);
  vec3 v = toEye(vPoint);
  vec3 color = vColor * (0.25 + 0.35 * max(n.y, 0.0)) + surroundings(reflect(-v, n)) * (0.25 + 0.75 * schlick(dot(n, v), 0.1));
  result = vec4(withFog(color, vPoint), 1.0);
}
)"};

}  // namespace brittle::render::glsl
