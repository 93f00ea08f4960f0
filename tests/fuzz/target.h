// fuzz/target.h - what every target offers: one input, tried. A claim that does not hold asserts. Linked with
// driver.cpp it runs its corpus and inputs made from it by a fixed seed; linked with libFuzzer (tools/fuzz) it searches
// for hours.
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
