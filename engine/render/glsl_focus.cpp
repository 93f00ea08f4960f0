#include "engine/render/glsl.h"

namespace brittle::render::glsl {

static constexpr const char* kWholePicture = R"(
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(corner, 1.0, 1.0);
}
)";

// Half as large; alpha is how far out of focus it is. Sharp pixels count little, so that what is near does not bleed
// into what is far.
const ProgramSource kFar = {"far", kWholePicture, R"(
uniform sampler2D colorTexture;
uniform sampler2D depthTexture;
uniform vec4 tap;  // sharp up to here, 1 / range, strength
out vec4 result;
float blurAt(ivec2 at) {
  float n = frame.forward.w, f = frame.eye.w;
  float stored = texelFetch(depthTexture, at, 0).r;
  float depth = 2.0 * n * f / (f + n - (2.0 * stored - 1.0) * (f - n));
  return clamp((depth - tap.x) * tap.y, 0.0, 1.0) * tap.z;
}
void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * 2, last = ivec2(frame.picture.xy) - 1;
  vec3 sum = vec3(0.0);
  float weights = 0.0, blur = 0.0;
  for (int i = 0; i < 4; ++i) {
    ivec2 at = min(first + ivec2(i & 1, i >> 1), last);
    float b = blurAt(at), w = b + 0.01;
    sum += texelFetch(colorTexture, at, 0).rgb * w;
    weights += w;
    blur += 0.25 * b;
  }
  result = vec4(sum / weights, blur);
}
)"};

// A disc of 20 places, each weighted by how far out of focus what is there is. Source: Demers, Depth of Field: A Survey
// of Techniques, 2004.
const ProgramSource kDisc = {"disc", kWholePicture, R"(
uniform sampler2D colorTexture;
uniform vec4 tap;  // radius of the disc [picture]
out vec4 result;
const vec2 places[20] = vec2[20](
    vec2(0.000, 0.000), vec2(-0.169, 0.155), vec2(0.028, -0.323), vec2(0.236, 0.307), vec2(-0.440, -0.078),
    vec2(0.422, -0.268), vec2(-0.144, 0.529), vec2(-0.275, -0.524), vec2(0.586, 0.214), vec2(-0.603, 0.279),
    vec2(0.265, -0.651), vec2(0.259, 0.695), vec2(-0.676, -0.364), vec2(0.760, -0.196), vec2(-0.431, 0.703),
    vec2(-0.159, -0.838), vec2(0.706, 0.540), vec2(-0.918, 0.072), vec2(0.645, -0.688), vec2(0.000, 0.974));
void main() {
  vec2 at = gl_FragCoord.xy / vec2(textureSize(colorTexture, 0));
  float own = texture(colorTexture, at).a;
  vec3 sum = vec3(0.0);
  float weights = 0.0;
  for (int i = 0; i < 20; ++i) {
    vec4 c = texture(colorTexture, at + places[i] * tap.xy * own);
    float w = c.a + 0.002;
    sum += c.rgb * w;
    weights += w;
  }
  result = vec4(sum / weights, own);
}
)"};

const ProgramSource kFocus = {"focus", kWholePicture, R"(
uniform sampler2D colorTexture;  // half as large, blurred
uniform sampler2D depthTexture;
uniform vec4 tap;                // sharp up to here, 1 / range, strength
out vec4 result;
void main() {
  float n = frame.forward.w, f = frame.eye.w;
  float stored = texelFetch(depthTexture, ivec2(gl_FragCoord.xy), 0).r;
  float depth = 2.0 * n * f / (f + n - (2.0 * stored - 1.0) * (f - n));
  float blur = clamp((depth - tap.x) * tap.y, 0.0, 1.0) * tap.z;
  result = vec4(texture(colorTexture, gl_FragCoord.xy * frame.picture.zw).rgb, smoothstep(0.0, 0.25, blur));
}
)"};

}  // namespace brittle::render::glsl
