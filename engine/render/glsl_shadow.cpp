#include "engine/render/glsl.h"

namespace brittle::render::glsl {

// A box below each caster; the depth picture says which point of the scene a pixel shows, and its distance from the
// caster's outline and underside says how dark it gets. What does not look up stays as it is.
const ProgramSource kShadow = {"shadow", R"(
layout(location = 1) in vec4 place;  // middle of the underside or centre of a ball, reach
layout(location = 2) in vec4 form;   // half width and depth, cosine and sine of the turn
layout(location = 3) in vec2 shade;  // opacity, 1 for a ball
flat out vec4 vPlace;
flat out vec4 vForm;
flat out vec2 vShade;
const int order[14] = int[14](3, 2, 6, 7, 4, 2, 0, 3, 1, 6, 5, 4, 1, 0);
void main() {
  int corner = order[gl_VertexID];
  vec2 unit = vec2((corner & 1) != 0 ? 1.0 : -1.0, (corner & 2) != 0 ? 1.0 : -1.0);
  vec2 flat2 = unit * (form.xy + mix(0.05 + 0.3 * place.w, 0.7 * form.x, shade.y));
  vec3 at = vec3(form.z * flat2.x + form.w * flat2.y, (corner & 4) != 0 ? 0.0 : -place.w, form.z * flat2.y - form.w * flat2.x);
  vPlace = place;
  vForm = form;
  vShade = shade;
  gl_Position = frame.viewProjection * vec4(place.xyz + at, 1.0);
}
)",
                               R"(
uniform sampler2D depthTexture;
flat in vec4 vPlace;
flat in vec4 vForm;
flat in vec2 vShade;
out vec4 result;
float ball(vec3 d) {
  float below = -d.y;
  float spread = 1.0 + 0.1 * max(below - 1.0, 0.0);
  float core = smoothstep(1.3, 0.1, length(d.xz) / spread) / (spread * spread);
  float reach = smoothstep(0.0, 0.45, below) * smoothstep(4.0, 2.0, below);
  return core * reach * smoothstep(1.0, 1.06, length(d));  // a ball does not darken itself
}
float slab(vec3 d) {
  float below = -d.y;
  vec2 q = abs(vec2(vForm.z * d.x - vForm.w * d.z, vForm.w * d.x + vForm.z * d.z)) - vForm.xy;
  float outside = length(max(q, 0.0)) + min(max(q.x, q.y), 0.0);
  float soft = 0.03 + 0.3 * below;
  float narrow = min(vForm.x, vForm.y);
  float core = smoothstep(soft, -soft, outside) * min((narrow + 0.04) / (narrow + soft), 1.0);
  float left = max(1.0 - below / vPlace.w, 0.0);
  return core * left * left * smoothstep(-0.02, 0.02, below);
}
void main() {
  float n = frame.forward.w, f = frame.eye.w;
  float stored = texelFetch(depthTexture, ivec2(gl_FragCoord.xy), 0).r;
  float depth = 2.0 * n * f / (f + n - (2.0 * stored - 1.0) * (f - n));
  vec2 ndc = gl_FragCoord.xy * frame.picture.zw * 2.0 - 1.0;
  vec3 ray = frame.forward.xyz + frame.right.xyz * (ndc.x * frame.right.w) + frame.up.xyz * (ndc.y * frame.up.w);
  vec3 seen = ray * depth;
  vec3 normal = cross(dFdx(seen), dFdy(seen));
  float up = smoothstep(0.15, 0.5, abs(normal.y) / (length(normal) + 1e-9));
  vec3 d = frame.eye.xyz + seen - vPlace.xyz;
  float dark = vShade.y > 0.5 ? ball(d / vForm.x) : slab(d);
  result = vec4(0.0, 0.0, 0.0, vShade.x * dark * up * (1.0 - fogAt(depth)));
}
)"};

}  // namespace brittle::render::glsl
