// brittle/interrupt.h - Ctrl-C during long work: the work ends at its next look here, so that what is half-written goes
// away as after any other failure. Knows nothing of the work.
#pragma once

#include <sys/types.h>

namespace brittle::program {

/// From now on the first Ctrl-C (SIGINT) is only remembered, and a second one ends the program at once.
void catchInterrupts();
bool isInterrupted();

/// A process that ends with the first Ctrl-C, so that nobody waits for it; -1: none.
void endOnInterrupt(pid_t child);

}  // namespace brittle::program
