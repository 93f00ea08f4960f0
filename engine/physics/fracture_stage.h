// physics/fracture_stage.h - what the step does about glass that breaks. Left out of the step, everything is rigid.
#pragma once

namespace brittle::physics {

struct State;

/// Before contacts are found: last tick's spending fades, and what was held breaks.
void beginBreaking(State& state, float dt);
/// After a pass: breaks what it saturated, or moves strikers on to what they reach. True if that calls for another one.
/// `round` counts the breakings of the tick.
bool breakOrAdvance(State& state, int& round, float dt);
/// After the last pass: what is still saturated is held, and strikes are charged.
void endBreaking(State& state, float dt);

}  // namespace brittle::physics
