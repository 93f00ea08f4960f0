// audio/synthesis.h - the sounds of the game, computed: glass by the size of what breaks, balls on what they meet,
// bells, doors, a crash. Each is a function of its arguments and its random stream, with our own trigonometry: the same
// samples on every machine.
#pragma once

#include "engine/audio/clip.h"
#include "engine/core/random.h"

namespace brittle::audio {

/// What is hit.
enum class Struck { Stone, Wall, Metal, Wood, Glass, Steel };

/// A thing of glass of this size (cube root of its volume) breaks: the crack, then shards that ring and knock against
/// each other. [m]
Samples glassBreak(float size, Random& random);
/// What falls down afterwards, over a second.
Samples shardRain(Random& random);
/// One shard of this side hops to rest. [m]
Samples tinkle(float side, Random& random);

/// Something heavy, hard and compact meets `struck`. Steel: a ball meets a ball.
Samples knock(Struck struck, Random& random);

/// A struck bell of this pitch. [Hz]
Samples bell(float pitch);
/// The pitch of a MIDI note number, equal temperament, A4 = 440 Hz = 69. [Hz]
float pitchOf(float note);

/// The camera runs into something.
Samples crash(Random& random);
/// Two leaves unlatch, slide apart and stop.
Samples door(Random& random);
/// A ball leaves the hand.
Samples swoosh(Random& random);
/// Something falls into water, of four sizes: 0 a drop, 3 a heavy thing.
Samples splash(int size, Random& random);
/// A steady beam: rises and falls like half a sine, so that two of them half a length apart sound as one.
Samples laserHum(Random& random);
/// A beam burns into something.
Samples laserHit(Random& random);
/// A beam's source bursts, or it strikes somebody.
Samples laserDischarge(Random& random);
/// A glass tone that sags: a chance was missed.
Samples sigh();

/// Four glass tubes, upwards: something was collected.
Samples powerUpTaken();
/// Something rises and rings: it is used, and begins.
Samples powerUpBegins(Random& random);
/// And falls off: it has run out.
Samples powerUpEnds(Random& random);

}  // namespace brittle::audio
