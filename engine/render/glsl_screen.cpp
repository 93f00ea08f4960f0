#include "engine/render/glsl.h"

namespace brittle::render::glsl {

const ProgramSource kBackground = {"background", kScreenVertex, R"(
out vec4 result;
void main() { result = vec4(fogColor(), 1.0); }
)"};

// Segments widened to about a pixel. An end behind the near plane is moved onto it; lines thinner than a pixel fade
// instead.
const ProgramSource kEdge = {"edge", R"(
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in uint slot;
layout(location = 3) in float strength;
out float vAcross;
out vec3 vPoint;
flat out vec4 vColor;
flat out float vWidth;
flat out vec3 vAlong;  // unit
void main() {
  uvec4 shape = fetchShape(slot);
  Pose pose = fetchBody(shape.x);
  vec3 a = rotate(pose.rotation, from) + pose.position;
  vec3 b = rotate(pose.rotation, to) + pose.position;
  float da = dot(a - frame.eye.xyz, frame.forward.xyz) - frame.forward.w;
  float db = dot(b - frame.eye.xyz, frame.forward.xyz) - frame.forward.w;
  vColor = vec4(mix(vec3(1.0), materials.surface[int(shape.y)].rgb * decode(unpackColor(shape.z).rgb), 0.35), strength);
  vAlong = normalize(b - a + vec3(1e-7));
  vWidth = 0.0;
  vAcross = 0.0;
  vPoint = a;
  gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
  if (da <= 0.0 && db <= 0.0) return;
  if (da < 0.0) a = mix(a, b, da / (da - db));
  if (db < 0.0) b = mix(b, a, db / (db - da));
  vec4 ca = frame.viewProjection * vec4(a, 1.0);
  vec4 cb = frame.viewProjection * vec4(b, 1.0);
  vec2 along = (cb.xy / cb.w - ca.xy / ca.w) * frame.picture.xy;
  float len = length(along);
  along = len > 1e-4 ? along / len : vec2(1.0, 0.0);
  bool atEnd = gl_VertexID >= 2;
  float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  vec4 c = atEnd ? cb : ca;
  float pixels = 0.004 * frame.picture.y / (2.0 * frame.up.w * c.w);  // of a line 4 mm wide
  vWidth = clamp(pixels, 0.9, 4.0) * 0.5;
  vColor.a *= clamp(pixels, 0.3, 1.0);
  vAcross = side * (vWidth + 1.0);
  vPoint = atEnd ? b : a;
  c.xy += vec2(-along.y, along.x) * (vAcross * 2.0 * c.w) * frame.picture.zw;
  c.z -= 0.0004 * c.w;
  gl_Position = c;
}
)",
                             R"(
in float vAcross;
in vec3 vPoint;
flat in vec4 vColor;
flat in float vWidth;
flat in vec3 vAlong;
out vec4 result;
void main() {
  float cover = clamp(vWidth + 0.5 - abs(vAcross), 0.0, 1.0);
  // A polished edge is a thin cylinder: it flashes where it lies across the way from the light to the eye.
  vec3 middle = normalize(toEye(vPoint) + frame.toLight.xyz);
  float along = dot(vAlong, middle);
  float flash = pow(max(1.0 - along * along, 0.0), 24.0);
  vec3 light = vColor.rgb * (0.35 + 0.65 * frame.high.rgb) * (0.55 + 0.9 * flash);
  result = vec4(light, 0.85) * (vColor.a * (0.55 + 0.45 * flash) * cover * clearAt(depthOf(vPoint)));
}
)"};

const ProgramSource kGlow = {"glow", R"(
layout(location = 1) in vec4 place;  // centre, radius
layout(location = 2) in vec4 color;
layout(location = 3) in vec2 form;   // how much it covers, how much of a star it is
out vec2 vAt;
out vec3 vPoint;
flat out vec4 vColor;
flat out vec2 vForm;
void main() {
  vAt = vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, gl_VertexID < 2 ? -1.0 : 1.0);
  vPoint = place.xyz + (frame.right.xyz * vAt.x + frame.up.xyz * vAt.y) * place.w;
  vColor = vec4(decode(color.rgb), color.a);
  vForm = form;
  gl_Position = frame.viewProjection * vec4(vPoint, 1.0);
}
)",
                             R"(
in vec2 vAt;
in vec3 vPoint;
flat in vec4 vColor;
flat in vec2 vForm;
out vec4 result;
void main() {
  float fall = max(1.0 - length(vAt), 0.0);
  float disc = fall * fall;
  float rays = max(1.0 - 14.0 * abs(vAt.x * vAt.y) - 0.6 * length(vAt), 0.0) * fall;
  float light = mix(disc, rays + disc * disc * disc * 2.0, vForm.y);
  float alpha = vColor.a * light * clearAt(depthOf(vPoint));
  result = vec4(vColor.rgb * alpha, alpha * vForm.x);
}
)"};

const ProgramSource kBeam = {"beam", R"(
layout(location = 0) in vec4 from;  // point, radius
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 color;
out float vAcross;
out vec3 vPoint;
flat out vec4 vColor;
void main() {
  vec3 base = gl_VertexID >= 2 ? to : from.xyz;
  vec3 side = cross(to - from.xyz, base - frame.eye.xyz);
  float len = length(side);
  vAcross = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  vPoint = base + (len > 1e-6 ? side / len : frame.up.xyz) * (from.w * vAcross);
  vColor = vec4(decode(color.rgb), color.a);
  gl_Position = frame.viewProjection * vec4(vPoint, 1.0);
}
)",
                             R"(
in float vAcross;
in vec3 vPoint;
flat in vec4 vColor;
out vec4 result;
void main() {
  float a = 1.0 - abs(vAcross);
  vec3 light = vColor.rgb * (a * a) + vec3(smoothstep(0.7, 0.95, a) * 0.8);
  result = vec4(light * (vColor.a * clearAt(depthOf(vPoint))), 0.0);
}
)"};

// Linear scene to an encoded picture, with the tints over it and half a step of ordered noise against bands in the fog.
const ProgramSource kComposite = {"composite", kScreenVertex, R"(
uniform sampler2D colorTexture;
uniform vec4 tint;
uniform vec4 border;
uniform sampler2D bloomTexture;
uniform vec4 tap;  // x: strength of the bloom
out vec4 result;
void main() {
  vec3 c = texelFetch(colorTexture, ivec2(gl_FragCoord.xy), 0).rgb;
  if (tap.x > 0.0) c += texture(bloomTexture, gl_FragCoord.xy * frame.picture.zw).rgb * tap.x;
  vec3 s1 = sqrt(c), s2 = sqrt(s1), s3 = sqrt(s2);  // within 0.002 of the exact curve, and roots are cheap
  c = max(0.662002687 * s1 + 0.684122060 * s2 - 0.323583601 * s3 - 0.0225411470 * c, 0.0);
  vec2 at = gl_FragCoord.xy * frame.picture.zw * 2.0 - 1.0;
  vec2 far = at * at;
  c *= 1.0 - 0.10 * smoothstep(0.5, 2.0, far.x + far.y);
  c = mix(c, tint.rgb, tint.a);
  float edge = smoothstep(0.35, 1.0, max(far.x * far.x, far.y * far.y));
  c = mix(c, border.rgb, border.a * edge);
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  result = vec4(c + (noise - 0.5) / 255.0, 1.0);
}
)"};

// kind 0: rectangle about ends.xy with half size ends.zw, form.x = radius of its corners; 1: arc about ends.xy from
// ends.z to ends.w turns, form = outer, inner radius; 2: glyph with its origin at ends.xy, ends.z pixels a unit, row
// ends.w of the atlas, form = half its stroke and radius of its shade. All in pixels, y down. The atlas is laid out as
// text.h says.
const ProgramSource kHud = {"hud", R"(
layout(location = 0) in vec4 ends;
layout(location = 1) in vec4 form;  // z: kind
layout(location = 2) in vec4 color;
out vec2 vAt;
flat out vec4 vEnds;
flat out vec3 vForm;
flat out vec4 vColor;
void main() {
  vec2 low, high;
  if (form.z > 1.5) {
    vec2 reach = vec2(min(form.x + form.y + 1.0, 3.0 * ends.z));
    low = ends.xy - vec2(0.0, 12.0) * ends.z - reach;
    high = ends.xy + vec2(8.0, 0.0) * ends.z + reach;
  } else {
    vec2 reach = (form.z < 0.5 ? ends.zw : vec2(form.x)) + 1.0;
    low = ends.xy - reach;
    high = ends.xy + reach;
  }
  vAt = vec2((gl_VertexID & 1) == 0 ? low.x : high.x, gl_VertexID < 2 ? low.y : high.y);
  vEnds = ends;
  vForm = form.xyz;
  vColor = color;
  vec2 ndc = vAt * frame.picture.zw * 2.0 - 1.0;
  gl_Position = vec4(ndc.x, -ndc.y, 0.0, 1.0);
}
)",
                            R"(
uniform sampler2D glyphTexture;  // distance to the strokes; 1 is 4 units
in vec2 vAt;
flat in vec4 vEnds;
flat in vec3 vForm;
flat in vec4 vColor;
out vec4 result;
float rectangle(vec2 p) {
  vec2 q = abs(p) - vEnds.zw + vForm.x;
  return length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - vForm.x;
}
float arc(vec2 p) {
  float reach = length(p);
  float ring = max(reach - vForm.x, vForm.y - reach);
  float sweep = vEnds.w - vEnds.z;
  if (sweep >= 1.0) return ring;
  float turn = fract(atan(p.x, -p.y) / 6.2831853 - vEnds.z);
  float over = min(abs(turn - sweep), 1.0 - turn);
  return turn < sweep ? ring : max(ring, over * 6.2831853 * reach);
}
float glyph(vec2 p) {
  vec2 cell = vec2(mod(vEnds.w, 12.0), floor(vEnds.w / 12.0));
  vec2 texel = clamp((p / vEnds.z + vec2(3.0, 15.0)) * 2.0, vec2(0.5), vec2(27.5, 35.5)) + cell * vec2(28.0, 36.0);
  return texture(glyphTexture, texel / vec2(textureSize(glyphTexture, 0))).r * 4.0 * vEnds.z - vForm.x;
}
void main() {
  vec2 p = vAt - vEnds.xy;
  if (vForm.z > 1.5) {
    float d = glyph(p);
    float inside = clamp(0.5 - d, 0.0, 1.0);
    float shade = clamp(1.0 - d / vForm.y, 0.0, 1.0);  // keeps light letters readable in light rooms
    shade *= 0.30 * shade;
    float cover = inside + (1.0 - inside) * shade;
    result = vec4(vColor.rgb * (inside / max(cover, 1e-4)), vColor.a * cover);
  } else {
    float d = vForm.z < 0.5 ? rectangle(p) : arc(p);
    result = vec4(vColor.rgb, vColor.a * clamp(0.5 - d, 0.0, 1.0));
  }
}
)"};

const ProgramSource kOverlay = {"overlay", R"(
layout(location = 0) in vec2 point;
layout(location = 1) in vec2 texel;
layout(location = 2) in vec4 color;
out vec2 vTexel;
out vec4 vColor;
void main() {
  vTexel = texel;
  vColor = color;
  vec2 ndc = point * frame.picture.zw * 2.0 - 1.0;
  gl_Position = vec4(ndc.x, -ndc.y, 0.0, 1.0);
}
)",
                                R"(
uniform sampler2D coverageTexture;
in vec2 vTexel;
in vec4 vColor;
out vec4 result;
void main() { result = vec4(vColor.rgb, vColor.a * texture(coverageTexture, vTexel).r); }
)"};

}  // namespace brittle::render::glsl
