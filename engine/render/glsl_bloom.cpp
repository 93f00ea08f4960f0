#include "engine/render/glsl.h"

namespace brittle::render::glsl {

// The brightest parts of the scene, four by four pixels to one.
const ProgramSource kBright = {"bright", kScreenVertex, R"(
uniform sampler2D colorTexture;
out vec4 result;
vec3 tap(vec2 at) { return texture(colorTexture, at * frame.picture.zw).rgb; }
void main() {
  vec2 at = gl_FragCoord.xy * 4.0;
  vec3 c = 0.25 * (tap(at + vec2(-1.0, -1.0)) + tap(at + vec2(1.0, -1.0)) + tap(at + vec2(-1.0, 1.0)) + tap(at + vec2(1.0, 1.0)));
  float bright = max(c.r, max(c.g, c.b));
  result = vec4(c * smoothstep(0.80, 1.0, bright), 1.0);
}
)"};

// Nine weights of a bell in five look-ups: between two texels the sampler adds them for us.
const ProgramSource kBlur = {"blur", kScreenVertex, R"(
uniform sampler2D bloomTexture;
uniform vec4 tap;  // one texel along
out vec4 result;
void main() {
  vec2 at = gl_FragCoord.xy / vec2(textureSize(bloomTexture, 0));
  vec3 c = texture(bloomTexture, at).rgb * 0.227027;
  c += (texture(bloomTexture, at + tap.xy * 1.384615).rgb + texture(bloomTexture, at - tap.xy * 1.384615).rgb) * 0.316216;
  c += (texture(bloomTexture, at + tap.xy * 3.230769).rgb + texture(bloomTexture, at - tap.xy * 3.230769).rgb) * 0.070270;
  result = vec4(c, 1.0);
}
)"};

}  // namespace brittle::render::glsl
