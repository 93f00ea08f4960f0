// core/assert.h - contract checks. A caller that broke a contract stops here, in every build; data errors use Result
// instead. The handler is replaceable so that tests can count failures.
#pragma once

namespace brittle {

using AssertHandler = void (*)(const char* condition, const char* file, int line);

/// Replaces what happens when an assertion fails (default: print one line and abort). Returns the handler it replaced.
AssertHandler setAssertHandler(AssertHandler handler);
void assertFailed(const char* condition, const char* file, int line);

}  // namespace brittle

#define BR_ASSERT(condition) ((condition) ? (void)0 : ::brittle::assertFailed(#condition, __FILE__, __LINE__))

// Costly invariants: on in debug builds only.
#ifdef BRITTLE_VALIDATE
#define BR_VALIDATE(condition) BR_ASSERT(condition)
#else
#define BR_VALIDATE(condition) ((void)0)
#endif
