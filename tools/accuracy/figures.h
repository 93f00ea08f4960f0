// accuracy/figures.h - the errors that the study states: of which scene, in what unit, how large one may be before it
// counts as 1, and how it follows from what was observed.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "tools/accuracy/observe.h"

namespace brittle::accuracy {

enum class Compared : std::uint8_t {
  WithExact,      // the figure is an error already: what is exact is known
  WithReference,  // percent that it is off the converged reference's
  AsSpeeds,       // Wasserstein-1 distance of all speeds from the reference's, in percent of its mean speed
};

struct Figure {
  std::string_view scene;
  std::string_view name;
  std::string_view unit;
  Compared compared;
  bool isWorst;      // of the variants; else their mean
  double tolerance;  // the error that counts as 1 in the score; 0: stands in the tables only
  double (*of)(const Observation& seen);
};

std::span<const Figure> allFigures();
/// The index of its scene in allScenes.
std::size_t sceneOf(const Figure& figure);

/// A figure's error with the bounds of its 95 % confidence, which are the error itself where nothing was sampled.
struct Deviation {
  double value = 0.0, low = 0.0, high = 0.0;
};

/// One error for each of allFigures, from all variants of every scene: `seen[s]` and `reference[s]` are those of scene
/// s of allScenes. NaN: the scene was not played.
std::vector<Deviation> errorsOf(const std::vector<std::vector<Observation>>& seen,
                                const std::vector<std::vector<Observation>>& reference);

/// The errors as one number: root mean square of error / tolerance, each at most kWorst. 1: as much as one would
/// notice.
inline constexpr double kWorst = 10.0;
double scoreOf(const std::vector<Deviation>& errors, double Deviation::*bound = &Deviation::value);

/// Distance of two samples' distributions: the area between their cumulative distributions.
double wassersteinOf(std::vector<float> a, std::vector<float> b);

}  // namespace brittle::accuracy
