#include "game/view/music.h"

#include "engine/core/hash.h"
#include "engine/core/random.h"
#include "engine/math/types.h"

namespace brittle::view {
namespace {

using audio::Instrument;

/// Chords by the degree of the scale they stand on, 0 for C.
constexpr std::int32_t kProgressions[][4] = {{5, 3, 0, 4}, {0, 2, 5, 3}, {3, 0, 4, 5},
                                             {1, 3, 0, 5}, {0, 5, 3, 1}, {5, 0, 3, 1}};
/// Steps of two bars on which the mallet plays, the first step highest.
constexpr std::uint16_t kRhythms[] = {0b1001001010010010, 0b1000100100101000, 0b1010010010100100, 0b1001000100100010};
/// The order in which it takes the chord's notes.
constexpr std::int32_t kOrders[][8] = {{0, 1, 2, 3, 2, 1, 3, 2}, {0, 2, 1, 3, 0, 3, 2, 1}, {3, 2, 1, 0, 2, 1, 3, 0}};
/// How much of it there is, chord by chord: the room fills, and empties before the door.
constexpr float kPresence[kChords] = {0.0f, 0.6f, 0.8f, 0.9f, 1.0f, 1.0f, 0.9f, 0.4f};

constexpr float kPadGain = 0.028f, kBassGain = 0.07f, kMalletGain = 0.05f;

/// The MIDI number of a degree of C major, 0 for C3; 7 degrees are an octave.
float noteOfDegree(std::int32_t degree) {
  constexpr float kMajor[] = {0, 2, 4, 5, 7, 9, 11};
  return 48.0f + 12.0f * static_cast<float>(degree / 7) + kMajor[degree % 7];
}

/// What the name decides.
struct Piece {
  std::uint64_t seed;
  const std::int32_t* chords;
  std::uint16_t rhythm;
  const std::int32_t* order;
  std::int32_t chordAt(std::int32_t index) const {
    // The last time round it does not come home: the next room's music does.
    return index == kChords - 1 ? 3 : chords[index % 4];
  }
};

template <class T, std::size_t count>
const T& pick(const T (&from)[count], Random& random) {
  return from[random.nextBelow(count)];
}

Piece pieceOf(const std::string& name) {
  Piece piece;
  piece.seed = hashBytes(name.data(), name.size());
  Random random(piece.seed);
  piece.chords = pick(kProgressions, random);
  piece.rhythm = pick(kRhythms, random);
  piece.order = pick(kOrders, random);
  return piece;
}

/// Root, fifth, and a third above the octave: open. Major chords have their ninth too, minor ones the seventh: a ninth
/// would rub.
void addChord(std::int32_t degree, std::vector<MusicNote>& notes) {
  const bool isMinor = degree == 1 || degree == 2 || degree == 5;
  const std::int32_t color = isMinor ? 6 : 8;
  float side = -0.6f;
  for (const std::int32_t above : {0, 4, color, 9}) {
    notes.push_back({Instrument::Pad, noteOfDegree(degree + above), kPadGain, side});
    side += 0.4f;
  }
  notes.push_back({Instrument::Bass, noteOfDegree(degree) - 12.0f, kBassGain, 0.0f});
}

void addMallet(const Piece& piece, std::int32_t chord, std::int32_t step, std::vector<MusicNote>& notes) {
  if ((piece.rhythm >> (kStepsPerChord - 1 - step) & 1) == 0) return;
  Random random(mixSeed(piece.seed, static_cast<std::uint64_t>(chord * kStepsPerChord + step)));
  const float chance = random.nextFloat();
  const float accent = random.nextFloat(0.6f, 1.0f);
  const float side = random.nextFloat(-0.7f, 0.7f);
  const bool sparkles = random.nextBelow(8) == 0;
  if (chance >= kPresence[chord]) return;
  constexpr std::int32_t kTones[] = {7, 9, 11, 14};  // of the chord, above its root
  const std::int32_t degree = piece.chordAt(chord) + kTones[piece.order[step / 2]] + (sparkles ? 7 : 0);
  notes.push_back({Instrument::Mallet, noteOfDegree(degree), kMalletGain * accent, side});
}

}  // namespace

bool hasMusic(const std::string& name) {
  return !name.empty() && name != "silent";
}

std::vector<MusicNote> notesAt(const std::string& name, std::int32_t tick) {
  std::vector<MusicNote> notes;
  if (!hasMusic(name) || tick < 0 || tick % kStepTicks != 0) return notes;
  const std::int32_t step = tick % kMusicTicks / kStepTicks;
  const Piece piece = pieceOf(name);
  const std::int32_t chord = step / kStepsPerChord;
  if (step % kStepsPerChord == 0) addChord(piece.chordAt(chord), notes);
  addMallet(piece, chord, step % kStepsPerChord, notes);
  return notes;
}

}  // namespace brittle::view
