// brittle/options.h - what the subcommands are told, and reading the values that are more than a number.
#pragma once

#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace brittle::program {

/// Exit statuses: done; the answer is no (a replay that differs, a smoke script or a level with faults); wrong input;
/// Ctrl-C (as a shell says it: 128 and the signal's number).
inline constexpr int kDone = 0, kFailed = 1, kWrongInput = 2, kInterrupted = 130;

struct Size {
  int width = 640, height = 360;  // [pixels]
};

/// Both ends belong to it. [ticks]
struct FrameRange {
  std::uint32_t first = 0, last = 0;
};

/// The whole of `text` as a number, or false.
template <class Number>
bool readWhole(std::string_view text, Number& number) {
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  return !text.empty() && problem == std::errc() && end == text.data() + text.size();
}

/// "1280x720"; each side in [1, 16384], at most 7680 * 4320 pixels.
Result<Size> parseSize(const std::string& text);
/// "600..900", or one frame as "600".
Result<FrameRange> parseFrames(const std::string& text);

struct GameOptions {
  std::string level = "first";
  std::uint64_t seed = 1;
  std::string mode = "classic";
  std::uint32_t room = 0;
  std::string accuracy = "balanced";
  std::string without;  // effects switched off, separated by commas
  std::string assets;   // empty: the folder that came with the program
};

struct PlayOptions {
  GameOptions game;
  std::string record;        // empty: nothing is recorded
  std::uint32_t frames = 0;  // 0: until the window is closed
  bool mute = false;
  std::string size = "1280x720";
};

struct RenderOptions {
  std::string replay, out, sound, assets;  // out, sound: empty if it is not asked for
  std::string size = "640x360";
  std::string frames;  // empty: all
  std::uint32_t every = 1;
  std::string backend = "egl";
  std::string accuracy;  // empty: what was recorded
  std::string without;
  int samples = 4;
};

struct VerifyOptions {
  std::vector<std::string> replays;
  std::uint32_t ticks = 0;  // only so many from the start; 0: all
  std::string assets;
};

struct SmokeOptions {
  std::vector<std::string> scripts;
  std::string record;                 // of a single script
  std::uint32_t seeds = 0;            // play each script with seeds 1 to this; 0: with its own
  std::vector<std::string> settings;  // NAME=TEXT
  std::string accuracy = "balanced";
  std::string without;
  std::string assets;
};

struct CheckOptions {
  std::vector<std::string> paths;
};

struct ExplainOptions {
  GameOptions game;
  std::uint32_t rooms = 3;
  bool json = false;
};

int play(const PlayOptions& options);
int render(const RenderOptions& options);
int verify(const VerifyOptions& options);
int smoke(const SmokeOptions& options);
int check(const CheckOptions& options);
int explain(const ExplainOptions& options);

/// Prints "brittle: message" to standard error, as one line.
void complain(const Error& error);
/// The same; the exit status. After Ctrl-C whatever failed did so because of it, and
/// the line says that instead.
int refuse(const Error& error);
/// What ended work says after Ctrl-C.
Error interruption();

}  // namespace brittle::program
