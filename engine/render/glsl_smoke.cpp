#include "engine/render/glsl.h"

namespace brittle::render::glsl {

// A ball of smoke on a quad that faces the eye: noise eats into its border, light comes from above, and where it meets
// a surface it thins out instead of ending in a line. Source: Lorach, Soft Particles, 2007.
const ProgramSource kPuff = {"puff", R"(
layout(location = 1) in vec4 place;  // centre, radius
layout(location = 2) in vec4 color;
layout(location = 3) in vec2 form;   // turn and number of its pattern
out vec2 vAt;
out vec3 vPoint;
flat out vec4 vColor;
flat out vec3 vForm;  // turn, pattern, radius
void main() {
  vAt = vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, gl_VertexID < 2 ? -1.0 : 1.0);
  vPoint = place.xyz + (frame.right.xyz * vAt.x + frame.up.xyz * vAt.y) * place.w;
  vColor = vec4(decode(color.rgb), color.a);
  vForm = vec3(form, place.w);
  gl_Position = frame.viewProjection * vec4(vPoint, 1.0);
}
)",
                             R"(
uniform sampler2D depthTexture;
in vec2 vAt;
in vec3 vPoint;
flat in vec4 vColor;
flat in vec3 vForm;
out vec4 result;
void main() {
  float reach = length(vAt);
  if (reach >= 1.0) discard;
  vec2 p = mat2(cos(vForm.x), sin(vForm.x), -sin(vForm.x), cos(vForm.x)) * vAt + vec2(vForm.y * 7.3, vForm.y * 3.1);
  float cloud = 0.55 * noise(p * 2.3) + 0.30 * noise(p * 5.1 + 4.0) + 0.15 * noise(p * 11.0 + 9.0);
  float body = 1.0 - reach * reach;
  float thick = smoothstep(0.10, 0.85, body * (0.30 + 1.4 * cloud));

  float n = frame.forward.w, f = frame.eye.w;
  float stored = texelFetch(depthTexture, ivec2(gl_FragCoord.xy), 0).r;
  float behind = 2.0 * n * f / (f + n - (2.0 * stored - 1.0) * (f - n));
  float depth = depthOf(vPoint);
  float thickness = vForm.z * sqrt(body);  // how far the ball reaches before and behind its middle here
  float soft = clamp((behind - depth + thickness) / (2.0 * thickness + 1e-3), 0.0, 1.0);
  float near = smoothstep(0.25, 1.1, depth);  // before the eye it would hide everything
  float alpha = vColor.a * thick * soft * near;

  vec3 normal = frame.right.xyz * vAt.x + frame.up.xyz * vAt.y - frame.forward.xyz * sqrt(body);
  float lit = 0.5 + 0.5 * dot(normal, frame.toLight.xyz);
  vec3 light = mix(frame.low.rgb * 0.6 + 0.14, frame.high.rgb * 0.8 + 0.45 * frame.lightColor.rgb, lit * (0.6 + 0.4 * cloud));
  result = vec4(withFog(vColor.rgb * light, vPoint), 1.0) * (alpha * partAt(depth));
}
)"};

}  // namespace brittle::render::glsl
