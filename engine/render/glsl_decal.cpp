#include "engine/render/glsl.h"

namespace brittle::render::glsl {

// Drawn a little before the surface it lies on.
const ProgramSource kDecal = {"decal", R"(
layout(location = 0) in vec4 place;  // centre, cell of the atlas
layout(location = 1) in vec4 right;  // half its width, coverage
layout(location = 2) in vec3 up;
layout(location = 3) in vec4 color;
out vec2 vAt;
out vec3 vPoint;
flat out vec4 vColor;
flat out float vCover;
void main() {
  vec2 corner = vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, gl_VertexID < 2 ? -1.0 : 1.0);
  vec2 cell = vec2(mod(place.w, 8.0), floor(place.w / 8.0));
  vec2 inside = vec2(0.5 + 0.5 * corner.x, 0.5 - 0.5 * corner.y);
  vAt = (cell + mix(vec2(0.03), vec2(0.97), inside)) / vec2(8.0, 9.0);
  vPoint = place.xyz + right.xyz * corner.x + up * corner.y;
  vColor = vec4(decode(color.rgb), color.a);
  vCover = right.w;
  gl_Position = frame.viewProjection * vec4(vPoint, 1.0);
  gl_Position.z -= 0.0006 * gl_Position.w;
}
)",
                              R"(
uniform sampler2D decalTexture;
in vec2 vAt;
in vec3 vPoint;
flat in vec4 vColor;
flat in float vCover;
out vec4 result;
void main() {
  float alpha = texture(decalTexture, vAt).r * vColor.a;
  float clear = 1.0 - fogAt(depthOf(vPoint));
  // What covers goes over into the fog; what only adds fades in it.
  vec3 color = vColor.rgb * (0.85 * clear) + fogColor() * ((1.0 - clear) * vCover);
  result = vec4(color, vCover) * alpha;
}
)"};

}  // namespace brittle::render::glsl
