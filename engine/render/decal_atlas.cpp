#include "engine/render/decal_atlas.h"

#include <cmath>

#include "engine/math/types.h"
#include "engine/render/text.h"

namespace brittle::render {

namespace {

constexpr int kMipLevels = 4;                 // 64 pixels a sprite to 8: below that neighbours would mix
constexpr float kEdge = 1.5f / kDecalPixels;  // outlines fade over this; a sprite reaches from -1 to 1
constexpr float kTurn = 6.2831853f;

/// Coverage where the distance to a shape is `d`.
float filled(float d) {
  return clampTo(0.5f - d / (2.0f * kEdge), 0.0f, 1.0f);
}

float ring(float r, float radius, float width) {
  return filled(std::fabs(r - radius) - width);
}

/// Distance to a regular polygon whose sides are `inner` from the middle; one corner points up.
float polygon(const Vec2& p, int corners, float inner) {
  const float part = kTurn / static_cast<float>(corners);
  const float turn = std::atan2(p.x(), p.y()) + 0.5f * kTurn + 0.5f * part * static_cast<float>(corners % 2 == 0);
  const float within = turn - part * std::floor(turn / part) - 0.5f * part;
  return p.norm() * std::cos(within) - inner;
}

/// Rays about the middle: `sharp` 1 is a star, below it a flower.
float star(const Vec2& p, int rays, float sharp) {
  const float turn = std::atan2(p.x(), p.y());
  const float wave = std::fabs(std::cos(0.5f * turn * static_cast<float>(rays)));
  return p.norm() - 0.85f * (1.0f - sharp + sharp * std::pow(wave, 3.0f));
}

float toSegment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 way = b - a;
  return (p - a - clampTo((p - a).dot(way) / way.squaredNorm(), 0.0f, 1.0f) * way).norm();
}

float chevron(const Vec2& p, float at) {
  const Vec2 tip(at + 0.25f, 0.0f);
  return minOf(toSegment(p, tip, Vec2(at - 0.25f, 0.55f)), toSegment(p, tip, Vec2(at - 0.25f, -0.55f)));
}

float arrow(const Vec2& p) {
  const float head =
      minOf(toSegment(p, Vec2(0.7f, 0.0f), Vec2(0.2f, 0.5f)), toSegment(p, Vec2(0.7f, 0.0f), Vec2(0.2f, -0.5f)));
  return minOf(head, toSegment(p, Vec2(-0.7f, 0.0f), Vec2(0.6f, 0.0f))) - 0.11f;
}

float letter(const Vec2& p, char c) {
  const float left = 0.5f * (glyphAdvance(c) - 3.4f);
  const Vec2 at(p.x() * 8.0f + left, p.y() * 8.0f + 6.0f);
  float nearest = 9.0f;
  for (const Stroke& stroke : glyphStrokes(glyphRow(c)))
    for (std::size_t i = 1; i < stroke.size(); ++i)
      if (stroke[i] != stroke[i - 1]) nearest = minOf(nearest, toSegment(at, stroke[i - 1], stroke[i]));
  return filled((nearest - 0.9f) / 8.0f);
}

float hash(int x, int y) {
  std::uint32_t h =
      static_cast<std::uint32_t>(x) * 0x85ebca6bu + static_cast<std::uint32_t>(y) * 0xc2b2ae35u + 0x9e3779b9u;
  h = (h ^ h >> 15) * 0x2c1b3c6du;
  h = (h ^ h >> 12) * 0x297a2d39u;
  return static_cast<float>((h ^ h >> 15) & 0xffffu) / 65535.0f;
}

/// A soft spot of uneven outline.
float stain(const Vec2& p, int variant) {
  const float turn = std::atan2(p.y(), p.x());
  float reach = 0.55f;
  for (int wave = 2; wave < 7; ++wave)
    reach +=
        0.10f * (hash(variant, wave) - 0.3f) * std::sin(turn * static_cast<float>(wave) + kTurn * hash(wave, variant));
  return clampTo((reach + 0.25f - p.norm()) / 0.35f, 0.0f, 1.0f);
}

/// Cracks from the middle, each of three crooked parts.
float crack(const Vec2& p, int variant) {
  float nearest = 9.0f;
  const int rays = 5 + variant;
  for (int ray = 0; ray < rays; ++ray) {
    Vec2 from = Vec2::Zero();
    float turn = kTurn * (static_cast<float>(ray) + 0.6f * hash(ray, variant)) / static_cast<float>(rays);
    for (int part = 0; part < 3; ++part) {
      turn += 0.7f * (hash(ray * 3 + part, variant + 40) - 0.5f);
      const Vec2 to = from + Vec2(std::cos(turn), std::sin(turn)) * (0.14f + 0.16f * hash(part, ray + variant));
      nearest = minOf(nearest, toSegment(p, from, to) + 0.012f * static_cast<float>(part));
      from = to;
    }
  }
  return maxOf(filled(nearest - 0.022f), 0.5f * clampTo(1.0f - p.norm() / 0.22f, 0.0f, 1.0f));
}

float sign(const Vec2& p, int index) {
  const float r = p.norm(), box = p.cwiseAbs().maxCoeff();
  const Vec2 turned(p.y(), -p.x());
  switch (index) {
    case 0:
      return filled(box - 0.9f);
    case 1:
      return filled(r - 0.85f);
    case 2:
      return ring(r, 0.75f, 0.09f);
    case 3:
      return maxOf(ring(r, 0.75f, 0.06f), ring(r, 0.45f, 0.06f));
    case 4:
      return filled(minOf(maxOf(std::fabs(p.x()) - 0.14f, box - 0.7f), maxOf(std::fabs(p.y()) - 0.14f, box - 0.7f)));
    case 5:
      return filled(minOf(toSegment(p, Vec2(-0.6f, -0.6f), Vec2(0.6f, 0.6f)),
                          toSegment(p, Vec2(-0.6f, 0.6f), Vec2(0.6f, -0.6f))) -
                    0.12f);
    case 6:
      return filled(polygon(p, 3, 0.42f));
    case 7:
      return filled(polygon(p, 4, 0.6f));
    case 8:
      return filled(arrow(p));
    case 9:
      return filled(arrow(turned));
    case 10:
      return filled(minOf(chevron(p, -0.3f), chevron(p, 0.3f)) - 0.10f);
    case 11:
      return filled(minOf(chevron(turned, -0.3f), chevron(turned, 0.3f)) - 0.10f);
    case 12:
      return filled(box - 0.95f) * filled((std::fabs(std::fmod(p.x() + p.y() + 4.0f, 0.5f) - 0.25f) - 0.125f) * 0.7f);
    case 13:
      return filled(box - 0.95f) * filled(std::fabs(std::fmod(p.y() + 4.0f, 0.25f) - 0.125f) - 0.045f);
    case 14:
      return filled(box - 0.95f) *
             (std::fmod(std::floor(p.x() * 4.0f) + std::floor(p.y() * 4.0f) + 64.0f, 2.0f) < 0.5f ? 1.0f : 0.0f);
    default:
      return filled(box - 0.95f) *
             filled(Vec2(std::fmod(p.x() + 4.0f, 0.4f) - 0.2f, std::fmod(p.y() + 4.0f, 0.4f) - 0.2f).norm() - 0.11f);
  }
}

float shape(const Vec2& p, int variant) {
  const float r = p.norm();
  switch (variant) {
    case 0:
      return filled(star(p, 5, 0.7f));
    case 1:
      return filled(star(p, 8, 0.6f));
    case 2:
      return filled(star(p, 6, 0.35f));
    case 3:
      return filled(star(p, 12, 0.25f)) * filled(0.3f - r);
    case 4:
      return filled(polygon(p, 6, 0.8f));
    case 5:
      return filled(std::fabs(polygon(p, 6, 0.72f)) - 0.07f);
    case 6:
      return filled(std::fabs(polygon(p, 4, 0.58f)) - 0.07f);
    default:
      return filled(std::fabs(polygon(p, 3, 0.40f)) - 0.06f);
  }
}

float light(const Vec2& p, int variant) {
  const float box = p.cwiseAbs().maxCoeff(), x = 0.5f + 0.5f * p.x(), y = 0.5f + 0.5f * p.y();
  const float soft = clampTo(1.0f - p.norm(), 0.0f, 1.0f);
  switch (variant) {
    case 0:
      return x;
    case 1:
      return y;
    case 2:
      return x * y;
    case 3:
      return soft * soft;
    case 4:
      return clampTo((1.0f - box) * 2.0f, 0.0f, 1.0f);
    case 5:
      return clampTo((0.92f - box) * 8.0f, 0.0f, 1.0f) *
             clampTo((minOf(std::fabs(p.x()), std::fabs(p.y())) - 0.05f) * 12.0f, 0.0f, 1.0f);
    case 6:
      return clampTo(1.0f - std::fabs(p.y()) * 4.0f, 0.0f, 1.0f);
    default:
      return clampTo(p.norm() - 0.3f, 0.0f, 1.0f);
  }
}

float emblem(const Vec2& p, int index) {
  const float r = p.norm();
  const float rim = maxOf(ring(r, 0.86f, 0.06f), ring(r, 0.70f, 0.02f));
  const float inner[] = {filled(polygon(p, 3, 0.26f)), filled(std::fabs(polygon(p, 6, 0.40f)) - 0.07f),
                         filled(polygon(p, 4, 0.36f)), filled(star(p * 1.6f, 5, 0.7f))};
  return maxOf(rim, inner[index]);
}

float coverage(int cell, const Vec2& p) {
  static constexpr char kLetters[] = "0123456789ABCDEF";
  if (cell < 16) return sign(p, cell);
  if (cell < 32) return letter(p, kLetters[cell - 16]);
  if (cell < 40) return stain(p, cell - 32);
  if (cell < 48) return crack(p, cell - 40);
  if (cell < 56) return shape(p, cell - 48);
  if (cell < 64) return light(p, cell - 56);
  return cell < 64 + kEmblems ? emblem(p, cell - 64) : 0.0f;
}

}  // namespace

std::vector<std::uint8_t> paintDecals() {
  constexpr int kWidth = kDecalsAcross * kDecalPixels, kHeight = kDecalRows * kDecalPixels;
  std::vector<std::uint8_t> atlas(static_cast<std::size_t>(kWidth) * kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const Vec2 p((static_cast<float>(x % kDecalPixels) + 0.5f) / kDecalPixels * 2.0f - 1.0f,
                   1.0f - (static_cast<float>(y % kDecalPixels) + 0.5f) / kDecalPixels * 2.0f);
      const float cover = coverage(y / kDecalPixels * kDecalsAcross + x / kDecalPixels, p);
      atlas[static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)] =
          static_cast<std::uint8_t>(clampTo(cover, 0.0f, 1.0f) * 255.0f + 0.5f);
    }
  }
  return atlas;
}

GlTexture makeDecalTexture(const Gl& gl) {
  return makeByteTexture(gl, kDecalsAcross * kDecalPixels, kDecalRows * kDecalPixels, kMipLevels, paintDecals());
}

}  // namespace brittle::render
