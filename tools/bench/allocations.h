// tools/bench/allocations.h - how many times the program has asked for memory: a warm tick should not.
#pragma once

#include <cstddef>

std::size_t allocationCount();
