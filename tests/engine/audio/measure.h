// Sounds by their numbers: level, spectrum, pitch, decay. Checked against sines and noise in test_measure.cpp before
// anything relies on them.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "engine/audio/clip.h"

namespace brittle::audio {

inline double peakOf(std::span<const float> samples) {
  double peak = 0.0;
  for (const float sample : samples) peak = std::max(peak, std::fabs(static_cast<double>(sample)));
  return peak;
}

inline double rmsOf(std::span<const float> samples) {
  double sum = 0.0;
  for (const float sample : samples) sum += static_cast<double>(sample) * static_cast<double>(sample);
  return samples.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(samples.size()));
}

inline double decibels(double ratio) {
  return 20.0 * std::log10(std::max(ratio, 1e-30));
}

/// Up to `count` samples from `from` on.
inline std::span<const float> part(std::span<const float> samples, double fromSeconds, double seconds) {
  const auto from = std::min(samples.size(), static_cast<std::size_t>(fromSeconds * kSampleRate));
  return samples.subspan(from, std::min(samples.size() - from, static_cast<std::size_t>(seconds * kSampleRate)));
}

inline std::size_t placeOfPeak(std::span<const float> samples) {
  std::size_t place = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (std::fabs(samples[i]) > std::fabs(samples[place])) place = i;
  return place;
}

/// Power per bin of a window of 4096 samples (93 ms would be 4464), Hann; what is missing is zero. Bin k is at k *
/// 48000 / 4096 Hz.
inline std::vector<double> spectrumOf(std::span<const float> samples) {
  constexpr std::size_t n = 4096;
  std::vector<std::complex<double>> a(n);
  for (std::size_t i = 0; i < n && i < samples.size(); ++i)
    a[i] = static_cast<double>(samples[i]) * (0.5 - 0.5 * std::cos(2.0 * M_PI * static_cast<double>(i) / n));
  for (std::size_t i = 1, j = 0; i < n; ++i) {
    std::size_t bit = n >> 1;
    for (; (j & bit) != 0; bit >>= 1) j ^= bit;
    j ^= bit;
    if (i < j) std::swap(a[i], a[j]);
  }
  for (std::size_t length = 2; length <= n; length <<= 1) {
    const std::complex<double> turn = std::polar(1.0, -2.0 * M_PI / static_cast<double>(length));
    for (std::size_t i = 0; i < n; i += length) {
      std::complex<double> w = 1.0;
      for (std::size_t k = 0; k < length / 2; ++k, w *= turn) {
        const std::complex<double> u = a[i + k], v = a[i + k + length / 2] * w;
        a[i + k] = u + v;
        a[i + k + length / 2] = u - v;
      }
    }
  }
  std::vector<double> power(n / 2);
  for (std::size_t k = 0; k < n / 2; ++k) power[k] = std::norm(a[k]);
  return power;
}

/// Centre of the spectrum's energy. [Hz]
inline double centroidOf(std::span<const float> samples) {
  const std::vector<double> power = spectrumOf(samples);
  double sum = 0.0, moment = 0.0;
  for (std::size_t k = 0; k < power.size(); ++k) {
    sum += power[k];
    moment += power[k] * static_cast<double>(k) * kSampleRate / 4096.0;
  }
  return sum > 0.0 ? moment / sum : 0.0;
}

/// The share of the energy that lies between two frequencies. [0, 1]
inline double shareBetween(std::span<const float> samples, double low, double high) {
  const std::vector<double> power = spectrumOf(samples);
  double sum = 0.0, inside = 0.0;
  for (std::size_t k = 0; k < power.size(); ++k) {
    const double frequency = static_cast<double>(k) * kSampleRate / 4096.0;
    sum += power[k];
    if (frequency >= low && frequency < high) inside += power[k];
  }
  return sum > 0.0 ? inside / sum : 0.0;
}

/// The strongest partial between two frequencies, as power of its bin.
inline double peakBetween(std::span<const float> samples, double low, double high) {
  const std::vector<double> power = spectrumOf(samples);
  double peak = 0.0;
  for (std::size_t k = 0; k < power.size(); ++k) {
    const double frequency = static_cast<double>(k) * kSampleRate / 4096.0;
    if (frequency >= low && frequency < high) peak = std::max(peak, power[k]);
  }
  return peak;
}

/// Energy at one frequency over the whole of `samples` (Goertzel).
inline double energyAt(std::span<const float> samples, double frequency) {
  const double a = 2.0 * std::cos(2.0 * M_PI * frequency / kSampleRate);
  double now = 0.0, before = 0.0;
  for (const float sample : samples) {
    const double next = static_cast<double>(sample) + a * now - before;
    before = now;
    now = next;
  }
  return now * now + before * before - a * now * before;
}

/// How far the strongest tone near `expected` is from it, searched within 40 cents in steps of a quarter. [cents]
inline double centsOff(std::span<const float> samples, double expected) {
  double best = 0.0, most = -1.0;
  for (double cents = -40.0; cents <= 40.0; cents += 0.25) {
    const double energy = energyAt(samples, expected * std::exp2(cents / 1200.0));
    if (energy > most) {
      most = energy;
      best = cents;
    }
  }
  return best;
}

/// Time to fall by 60 dB, from the slope between -5 and -35 dB of the energy that is still to come (Schroeder's
/// backward integral). [s]
inline double decayTimeOf(std::span<const float> samples) {
  std::vector<double> left(samples.size() + 1, 0.0);
  for (std::size_t i = samples.size(); i-- > 0;)
    left[i] = left[i + 1] + static_cast<double>(samples[i]) * static_cast<double>(samples[i]);
  const auto when = [&](double db) {
    std::size_t i = 0;
    while (i < samples.size() && left[i] > left[0] * std::pow(10.0, db / 10.0)) ++i;
    return static_cast<double>(i) / kSampleRate;
  };
  return (when(-35.0) - when(-5.0)) * 2.0;
}

inline std::span<const float> samplesOf(const Clip& clip) {
  return {clip.at(0), clip.size()};
}

}  // namespace brittle::audio
