#include "engine/physics/contact_block.h"

#include "engine/math/types.h"

namespace brittle::physics {
namespace {

// Each solve is held to the impulses it starts from by this part of the diagonal. Four points under one face are
// redundant, and rows in single precision make their matrix indefinite by 1e-7 of it; what this leaves undone the next
// sweep does. Beside a row that gives way a hundred times as easily, the rounding of that one counts: its part of the
// largest diagonal, ten times what floats round by.
constexpr double kSoftness = 1e-5;
constexpr double kRounding = 1e-6;
constexpr double kClosing = 1e-6;  // [m/s] slower is rounding
constexpr int kPatience = 3;       // exchanges that do not help before it goes on row by row
constexpr int kMaxSteps = 64;

Vec3 narrow(const Wide3<float>& v) {
  return Vec3(v.x, v.y, v.z);
}

double dotOf(const Wide3<float>& a, const Vec3& b) {
  return static_cast<double>(a.x) * b.x() + static_cast<double>(a.y) * b.y() + static_cast<double>(a.z) * b.z();
}

/// What a unit impulse of row j does to the velocity of one body, seen along row i of the same body.
double coupling(const Single& a, const Row<float>& rowA, std::uint32_t body, const Single& b, const Row<float>& rowB) {
  double sum = 0.0;
  const Vec3 normalB = narrow(b.rows.normal);
  const bool onA[2] = {a.bodyA == body, b.bodyA == body};
  const float invMass = onA[1] ? b.rows.invMassA : b.rows.invMassB;
  const double sign = onA[0] == onA[1] ? 1.0 : -1.0;
  sum += static_cast<double>(invMass) * dotOf(a.rows.normal, normalB);
  sum += dotOf(onA[0] ? rowA.angularA : rowA.angularB, narrow(onA[1] ? rowB.turnA : rowB.turnB));
  return sign * sum;
}

double entry(const Single& a, const Row<float>& rowA, const Single& b, const Row<float>& rowB) {
  double sum = 0.0;
  if (a.bodyA == b.bodyA || a.bodyA == b.bodyB) sum += coupling(a, rowA, a.bodyA, b, rowB);
  if (a.bodyB == b.bodyA || a.bodyB == b.bodyB) sum += coupling(a, rowA, a.bodyB, b, rowB);
  return sum;
}

double speedOf(const Single& single, const Row<float>& row, const std::vector<SolverBody>& bodies) {
  const SolverBody& a = bodies[single.bodyA];
  const SolverBody& b = bodies[single.bodyB];
  return dotOf(single.rows.normal, b.velocity) - dotOf(single.rows.normal, a.velocity) +
         dotOf(row.angularB, b.angularVelocity) - dotOf(row.angularA, a.angularVelocity);
}

/// Takes in the present speeds and impulses. True if every row is already as it should be.
bool isSolved(const Single* singles, const std::vector<SolverBody>& bodies, Block& block) {
  constexpr double kTolerance = 1e-6;  // [m/s]
  bool solved = true;
  for (int i = 0; i < block.count; ++i) {
    const Single& single = singles[block.rows[i].single];
    const Row<float>& row = single.rows.point[block.rows[i].point];
    const auto impulse = static_cast<double>(row.impulse);
    block.speed[i] = speedOf(single, row, bodies) - static_cast<double>(single.rows.target[block.rows[i].point]);
    block.rows[i].start = block.rows[i].impulse = impulse;
    block.rows[i].fixed = false;
    solved = solved && block.speed[i] >= -kTolerance && (impulse == 0.0 || block.speed[i] <= kTolerance);
  }
  return solved;
}

void start(Block& block) {
  for (int i = 0; i < block.count; ++i) {
    block.free[i] = block.speed[i] - block.softness[i] * block.rows[i].start;
    for (int j = 0; j < block.count; ++j) block.free[i] -= block.matrix[i][j] * block.rows[j].start;
    block.rows[i].active = block.rows[i].start > 0.0 || block.free[i] < 0.0;
  }
}

/// Speed of a row above target, softness included, at the block's impulses.
double speedAt(const Block& block, int i) {
  double speed = block.free[i] + block.softness[i] * block.rows[i].impulse;
  for (int j = 0; j < block.count; ++j) speed += block.matrix[i][j] * block.rows[j].impulse;
  return speed;
}

/// The impulses of the active rows that bring each exactly to its target, the fixed ones as they are. LDL^T in place.
void solveActive(Block& block) {
  int index[kMaxBlockRows];
  int n = 0;
  for (int i = 0; i < block.count; ++i)
    if (block.rows[i].active && !block.rows[i].fixed) index[n++] = i;
  double l[kMaxBlockRows][kMaxBlockRows];
  double d[kMaxBlockRows];
  double x[kMaxBlockRows];
  for (int i = 0; i < n; ++i) {
    x[i] = -block.free[index[i]];
    for (int j = 0; j < block.count; ++j)
      if (block.rows[j].fixed) x[i] -= block.matrix[index[i]][j] * block.rows[j].impulse;
  }
  for (int j = 0; j < n; ++j) {
    double pivot = block.matrix[index[j]][index[j]] + block.softness[index[j]];
    for (int k = 0; k < j; ++k) pivot -= l[j][k] * l[j][k] * d[k];
    d[j] = maxOf(pivot, block.softness[index[j]]);
    for (int i = j + 1; i < n; ++i) {
      double sum = block.matrix[index[i]][index[j]];
      for (int k = 0; k < j; ++k) sum -= l[i][k] * l[j][k] * d[k];
      l[i][j] = sum / d[j];
    }
  }
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < i; ++k) x[i] -= l[i][k] * x[k];
  for (int i = 0; i < n; ++i) x[i] /= d[i];
  for (int i = n - 1; i >= 0; --i)
    for (int k = i + 1; k < n; ++k) x[i] -= l[k][i] * x[k];
  for (int i = 0; i < block.count; ++i)
    if (!block.rows[i].fixed) block.rows[i].impulse = 0.0;
  for (int i = 0; i < n; ++i) block.rows[index[i]].impulse = x[i];
}

/// A row on the wrong side: active though it would pull, or left out though it closes.
bool isWrong(const Block& block, int i) {
  const BlockRow& row = block.rows[i];
  if (row.fixed) return false;
  return row.active ? row.impulse < 0.0 : speedAt(block, i) < -kClosing;
}

/// Exchanges all wrong rows until none is: fast, but it may run in circles. False: they have not been getting fewer.
/// Source: Judice, Pires, A block principal pivoting algorithm for large-scale strictly monotone LCPs, 1994.
bool exchangeAll(Block& block) {
  int fewest = kMaxBlockRows + 1;
  for (int patience = kPatience; patience > 0;) {
    solveActive(block);
    int wrong[kMaxBlockRows];
    int count = 0;
    for (int i = 0; i < block.count; ++i)
      if (isWrong(block, i)) wrong[count++] = i;
    if (count == 0) return true;
    patience = count < fewest ? kPatience : patience - 1;
    fewest = minOf(fewest, count);
    for (int k = 0; k < count; ++k) block.rows[wrong[k]].active = !block.rows[wrong[k]].active;
  }
  return false;
}

/// From the impulses `now` as far towards those of solveActive as none pulls; what has come to zero is left out. True:
/// all the way.
bool stepTowards(Block& block, double (&now)[kMaxBlockRows]) {
  double part = 1.0;
  for (int i = 0; i < block.count; ++i)
    if (block.rows[i].active && block.rows[i].impulse < 0.0)
      part = minOf(part, now[i] / (now[i] - block.rows[i].impulse));
  for (int i = 0; i < block.count; ++i) {
    BlockRow& row = block.rows[i];
    if (row.fixed || !row.active) continue;
    const bool ends = row.impulse < 0.0 && now[i] <= part * (now[i] - row.impulse);
    now[i] = ends ? 0.0 : now[i] + part * (row.impulse - now[i]);
    row.active = !ends;
    row.impulse = now[i];
  }
  return part == 1.0;
}

/// One row after the other from the impulses of the start. Each step takes energy out, so it may end anywhere.
/// Source: Lawson, Hanson, Solving Least Squares Problems, 1974, chapter 23.
void descend(Block& block) {
  double now[kMaxBlockRows];
  for (int i = 0; i < block.count; ++i) {
    now[i] = block.rows[i].fixed ? block.rows[i].impulse : block.rows[i].start;
    block.rows[i].active = now[i] > 0.0;
  }
  for (int step = 0; step < kMaxSteps; ++step) {
    solveActive(block);
    if (!stepTowards(block, now)) continue;
    int worst = -1;
    double slowest = -kClosing;
    for (int i = 0; i < block.count; ++i) {
      if (block.rows[i].fixed || block.rows[i].active || speedAt(block, i) >= slowest) continue;
      slowest = speedAt(block, i);
      worst = i;
    }
    if (worst < 0) return;
    block.rows[worst].active = true;
  }
  for (int i = 0; i < block.count; ++i) block.rows[i].impulse = now[i];
}

void solveRows(Block& block) {
  if (!exchangeAll(block)) descend(block);
}

bool applyLimits(const BlockLimit* limits, std::uint32_t limitCount, Block& block) {
  bool exceeded = false;
  for (std::uint32_t k = 0; k < limitCount; ++k) {
    double sum = 0.0;
    bool fixed = false;
    for (int i = 0; i < block.count; ++i) {
      if (block.rows[i].single < limits[k].first || block.rows[i].single >= limits[k].end) continue;
      sum += block.rows[i].impulse;
      fixed = fixed || block.rows[i].fixed;
    }
    if (fixed || sum <= static_cast<double>(limits[k].capacity)) continue;
    exceeded = true;
    const double scale = static_cast<double>(limits[k].capacity) / sum;
    for (int i = 0; i < block.count; ++i) {
      if (block.rows[i].single < limits[k].first || block.rows[i].single >= limits[k].end) continue;
      block.rows[i].fixed = true;
      block.rows[i].impulse *= scale;
    }
  }
  return exceeded;
}

/// Applies the new impulses. The light body's large opposite ones are summed in double, so that what is left of them is
/// right.
void applyRows(const Block& block, std::uint32_t light, Single* singles, std::vector<SolverBody>& bodies) {
  Vec3d linear = bodies[light].velocity.cast<double>();
  Vec3d angular = bodies[light].angularVelocity.cast<double>();
  const auto add = [&](std::uint32_t index, const Vec3& change, const Vec3& turn, double impulse) {
    if (index == light) {
      linear += change.cast<double>() * impulse;
      angular += turn.cast<double>() * impulse;
    } else {
      bodies[index].velocity += change * static_cast<float>(impulse);
      bodies[index].angularVelocity += turn * static_cast<float>(impulse);
    }
  };
  for (int i = 0; i < block.count; ++i) {
    Single& single = singles[block.rows[i].single];
    Row<float>& row = single.rows.point[block.rows[i].point];
    const double change = block.rows[i].impulse - static_cast<double>(row.impulse);
    const Vec3 normal = narrow(single.rows.normal);
    row.impulse = static_cast<float>(block.rows[i].impulse);
    add(single.bodyA, Vec3(-normal * single.rows.invMassA), Vec3(-narrow(row.turnA)), change);
    add(single.bodyB, Vec3(normal * single.rows.invMassB), narrow(row.turnB), change);
  }
  bodies[light].velocity = linear.cast<float>();
  bodies[light].angularVelocity = angular.cast<float>();
}

}  // namespace

void buildBlock(const Single* singles, std::uint32_t count, Block& block) {
  block.count = 0;
  for (std::uint32_t s = 0; s < count; ++s)
    for (int p = 0; p < singles[s].points; ++p) block.rows[block.count++] = {s, p, false, false, 0.0, 0.0};
  for (int i = 0; i < block.count; ++i) {
    const Single& a = singles[block.rows[i].single];
    const Row<float>& rowA = a.rows.point[block.rows[i].point];
    for (int j = 0; j <= i; ++j) {
      const Single& b = singles[block.rows[j].single];
      block.matrix[i][j] = block.matrix[j][i] = entry(a, rowA, b, b.rows.point[block.rows[j].point]);
    }
  }
  double most = 0.0;
  for (int i = 0; i < block.count; ++i) most = maxOf(most, block.matrix[i][i]);
  for (int i = 0; i < block.count; ++i) block.softness[i] = maxOf(kSoftness * block.matrix[i][i], kRounding * most);
}

void solveBlock(std::uint32_t light, Single* singles, const BlockLimit* limits, std::uint32_t limitCount,
                std::vector<SolverBody>& bodies, Block& block) {
  if (isSolved(singles, bodies, block)) return;
  start(block);
  solveRows(block);
  while (applyLimits(limits, limitCount, block)) solveRows(block);
  applyRows(block, light, singles, bodies);
}

}  // namespace brittle::physics
