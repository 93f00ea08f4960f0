// render/glsl.h - the sources of all shaders: GLES 3.0, the subset WebGL 2 has too. A program is header + common part +
// its own part. Colours in buffers are sRGB-encoded; shaders decode them and compute linearly; the scene's framebuffer
// encodes what is written.
#pragma once

#include "engine/render/shader.h"

namespace brittle::render::glsl {

extern const char* const kHeader;          // version, precisions, the uniform blocks, colour decoding
extern const char* const kScreenVertex;    // one triangle that covers the picture
extern const char* const kVertexCommon;    // rotations, body transforms
extern const char* const kFragmentCommon;  // fog, environment, surface shading

extern const ProgramSource kBackground;  // fog where nothing is
extern const ProgramSource kRoom;        // baked static geometry
extern const ProgramSource kSolid;       // opaque convexes
extern const ProgramSource kSphere;      // balls
extern const ProgramSource kCrumb;       // light debris
extern const ProgramSource kDecal;       // pictures on surfaces
extern const ProgramSource kShadow;      // soft blobs on what is below
extern const ProgramSource kGlass;       // translucent convexes
extern const ProgramSource kEdge;        // bright lines
extern const ProgramSource kGlow;        // additive discs
extern const ProgramSource kBeam;        // additive capsules
extern const ProgramSource kWater;       // a level surface with waves
extern const ProgramSource kLaser;       // beams with a halo
extern const ProgramSource kPuff;        // smoke
extern const ProgramSource kFar;         // what is out of focus, half as large
extern const ProgramSource kDisc;        // that, blurred
extern const ProgramSource kFocus;       // that, over the scene
extern const ProgramSource kBright;      // what shines beyond its outline, small
extern const ProgramSource kBlur;        // that, blurred one way
extern const ProgramSource kComposite;   // scene to picture
extern const ProgramSource kHud;         // capsules, rectangles, arcs
extern const ProgramSource kOverlay;     // flat triangles with a coverage

}  // namespace brittle::render::glsl
