#include "engine/render/glsl.h"

namespace brittle::render::glsl {

// What is below is looked up in the opaque picture, bent by the waves and darkened by its way through the water; what
// is above is the room as any mirror shows it; Fresnel's share lies between. Sources: Schlick, An Inexpensive BRDF
// Model, 1994; absorption by Beer and Lambert's law, red first, as in clear water but stronger: a pool here is a metre
// deep.
const ProgramSource kWater = {"water", R"(
layout(location = 0) in vec3 point;
layout(location = 1) in vec3 form;  // slopes along x and z, foam
out vec3 vPoint;
out vec3 vForm;
void main() {
  vPoint = point;
  vForm = form;
  gl_Position = frame.viewProjection * vec4(point, 1.0);
}
)",
                              R"(
uniform sampler2D colorTexture;  // the opaque picture
uniform sampler2D depthTexture;
uniform vec4 bend;               // x: strength of refraction [picture heights], 0 switches the look-up off
uniform vec4 offset;             // z: added to z where patterns stay in place [m], w: [s]
in vec3 vPoint;
in vec3 vForm;
out vec4 result;

float depthAt(vec2 at) {
  float n = frame.forward.w, f = frame.eye.w;
  return 2.0 * n * f / (f + n - (2.0 * texture(depthTexture, at).r - 1.0) * (f - n));
}
// The slope of waves too short for the grid: six of them, each its own way.
vec2 fineSlope(vec2 p, float t) {
  vec2 sum = vec2(0.0);
  for (int i = 0; i < 6; ++i) {
    float turn = 0.7 + 2.4 * float(i);
    vec2 way = vec2(cos(turn), sin(turn));
    float k = 9.0 * pow(1.42, float(i));  // [1/m]
    float wave = k * dot(way, p) - sqrt(9.81 * k) * t + 1.7 * float(i);
    sum += way * (cos(wave + 1.3 * sin(0.31 * wave)) * (0.020 + 0.003 * float(i)));
  }
  return sum;
}
// Light that the waves gather on what is below: bright threads where two drifting patterns cross.
float threads(vec2 p, float t) {
  p += 0.35 * vec2(noise(p * 0.9 + 0.2 * t), noise(p * 0.9 - 0.2 * t + 5.0));
  float a = noise(p * 2.1 + vec2(0.33, 0.21) * t) - noise(p * 2.1 - vec2(0.27, 0.30) * t + 9.0);
  float b = noise(p * 3.4 - vec2(0.25, 0.34) * t + 3.0) - noise(p * 3.4 + vec2(0.31, 0.22) * t + 17.0);
  return pow(max(1.0 - 1.7 * abs(a), 0.0), 5.0) + 0.6 * pow(max(1.0 - 1.7 * abs(b), 0.0), 5.0);
}
void main() {
  float depth = depthOf(vPoint);
  vec2 place = vPoint.xz + vec2(0.0, offset.z);
  float t = offset.w;
  float near = clamp(1.25 - 0.07 * depth, 0.0, 1.0);
  float patches = 0.35 + 1.1 * noise(place * 0.55 + vec2(0.06 * t, 0.02 * t));  // the air is not the same everywhere
  vec2 slope = vForm.xy + fineSlope(place, t) * (near * patches);
  vec3 n = normalize(vec3(-slope.x, 1.0, -slope.y));
  vec3 v = toEye(vPoint);
  if (v.y < 0.0) n = -n;
  float facing = max(dot(n, v), 0.03);
  float fresnel = schlick(facing, 0.02);

  vec3 deep = mix(frame.low.rgb, frame.high.rgb, 0.45) * vec3(0.20, 0.46, 0.50) + vec3(0.0, 0.010, 0.014);
  vec3 below = deep;
  float shore = 0.0, clearness = 0.0;
  if (bend.x > 0.0) {
    vec2 at = gl_FragCoord.xy * frame.picture.zw;
    vec2 tilt = vec2(dot(n - vec3(0.0, n.y, 0.0), frame.right.xyz), dot(n - vec3(0.0, n.y, 0.0), frame.up.xyz));
    float here = max(depthAt(at) - depth, 0.0);
    vec2 bent = at + tilt * (bend.x * 2.2 * min(here, 1.0) / (1.0 + 0.12 * depth)) * vec2(frame.picture.y * frame.picture.z, 1.0);
    float behind = depthAt(bent);
    if (behind < depth) {  // what stands before the water is not seen through it
      bent = at;
      behind = depth + here;
    }
    float way = max(behind - depth, 0.0) / max(dot(-v, frame.forward.xyz), 0.2);
    vec3 kept = exp(-way * vec3(0.46, 0.13, 0.10));
    vec3 ground = vPoint - v * way;
    float gathered = threads(ground.xz + vec2(0.0, offset.z) + 0.4 * slope, t) * exp(-0.22 * way) * smoothstep(0.05, 0.5, way);
    below = texture(colorTexture, bent).rgb * (0.86 + 1.15 * gathered * near) * kept + deep * (1.0 - kept);
    shore = smoothstep(0.10, 0.0, here * v.y / max(dot(-v, frame.forward.xyz), 0.2));
  }
  vec3 r = reflect(-v, n);
  r.y = max(r.y, 0.02);
  vec3 mirror = environment(vPoint, normalize(r), 0.35, 8);
  float glint = pow(max(dot(r, frame.toLight.xyz), 0.0), 260.0);
  vec3 light = frame.lightColor.rgb;
  vec3 color = mix(below, mirror, fresnel) + light * (1.6 * glint);

  // Foam is bubbles: cells whose walls break up as it thins out.
  float lace = noise(place * 9.0 + 0.8 * slope) * 0.6 + noise(place * 23.0 - vec2(0.2 * t, 0.0)) * 0.4;
  float foam = smoothstep(0.0, 0.34, vForm.z - 0.75 * lace * (1.0 - 0.5 * vForm.z)) * 0.85;
  foam = max(foam, shore * smoothstep(0.25, 0.7, lace + 0.25 * shore) * 0.35);
  vec3 white = (0.30 + 0.70 * frame.high.rgb) * (0.62 + 0.38 * lace);
  color = mix(color, white, foam);

  float cover = bend.x > 0.0 ? 1.0 : max(mix(0.72, 1.0, fresnel), foam);
  float clear = 1.0 - fogAt(depth);
  result = vec4(color * clear + fogColor() * (1.0 - clear), 1.0) * cover;
}
)"};

}  // namespace brittle::render::glsl
