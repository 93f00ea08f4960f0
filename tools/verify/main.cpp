// `brittle verify` alone: the game without window, GL and sound, so that every compiler can soon replay a game.
// usage: verify ASSETS TICKS REPLAY...    TICKS: only so many from the start; 0: all
#include "tools/brittle/options.h"

int main(int argc, char** argv) {
  namespace program = brittle::program;
  program::VerifyOptions options;
  if (argc < 4 || !program::readWhole(argv[2], options.ticks))
    return program::refuse({"usage: verify ASSETS TICKS REPLAY..."});
  options.assets = argv[1];
  options.replays.assign(argv + 3, argv + argc);
  return program::verify(options);
}
