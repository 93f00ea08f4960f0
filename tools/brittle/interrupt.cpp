#include "tools/brittle/interrupt.h"

#include <signal.h>

#include <atomic>
#include <csignal>

namespace brittle::program {
namespace {

volatile std::sig_atomic_t interrupted = 0;
std::atomic<pid_t> childToEnd = -1;
static_assert(std::atomic<pid_t>::is_always_lock_free, "a signal handler may not wait for a lock");

void onInterrupt(int) {
  interrupted = 1;
  const pid_t child = childToEnd;
  if (child > 0) kill(child, SIGKILL);
}

}  // namespace

void catchInterrupts() {
  struct sigaction action = {};
  action.sa_handler = onInterrupt;
  action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
}

bool isInterrupted() {
  return interrupted != 0;
}

void endOnInterrupt(pid_t child) {
  childToEnd = child;
}

}  // namespace brittle::program
