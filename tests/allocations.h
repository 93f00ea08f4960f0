// tests/allocations.h - how many times the program has asked for memory, and how much of it it has: a warm tick
// should ask for none, a world that goes on should not grow.
#pragma once

#include <cstddef>

/// Calls of operator new so far, of all threads.
std::size_t allocationCount();
/// What operator new has given out and not got back, as the C library rounds it. [bytes]
std::size_t allocatedBytes();
/// From now on memory comes filled with this byte, so that what reads it before it writes it does not pass for right;
/// -1: as it comes.
void fillAllocations(int byte);
