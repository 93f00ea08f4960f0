// math: from engine/math, so that it gives the same bits everywhere. What remains of the C library is exact by
// definition.
#include "engine/script/state.h"

#include "engine/math/trig.h"

#include <cmath>

namespace brittle::script {
namespace {

constexpr double kPiDouble = 3.14159265358979323846;

template <double (*Function)(double)>
int unary(lua_State* lua) {
  lua_pushnumber(lua, Function(luaL_checknumber(lua, 1)));
  return 1;
}

template <double (*Function)(double, double)>
int binary(lua_State* lua) {
  const double a = luaL_checknumber(lua, 1);
  const double b = luaL_checknumber(lua, 2);
  lua_pushnumber(lua, Function(a, b));
  return 1;
}

double absolute(double x) {
  return std::fabs(x);
}
double floorOf(double x) {
  return std::floor(x);
}
double ceilingOf(double x) {
  return std::ceil(x);
}
double rootOf(double x) {
  return std::sqrt(x);
}
double tangentOf(double x) {
  return sineOf(x) / cosineOf(x);
}
double arcSineOf(double x) {
  return arcTangentOf(x, std::sqrt((1.0 - x) * (1.0 + x)));
}
double arcCosineOf(double x) {
  return arcTangentOf(std::sqrt((1.0 - x) * (1.0 + x)), x);
}
double arcTangentOfOne(double x) {
  return arcTangentOf(x, 1.0);
}
double hyperbolicSine(double x) {
  return (exponentialOf(x) - exponentialOf(-x)) / 2.0;
}
double hyperbolicCosine(double x) {
  return (exponentialOf(x) + exponentialOf(-x)) / 2.0;
}
double hyperbolicTangent(double x) {
  return 1.0 - 2.0 / (exponentialOf(2.0 * x) + 1.0);
}
double remainderOf(double a, double b) {
  return std::fmod(a, b);
}
double toDegrees(double x) {
  return x / (kPiDouble / 180.0);
}
double toRadians(double x) {
  return x * (kPiDouble / 180.0);
}

/// Whole where the argument is a power of the base: scripts count on math.log(8, 2) == 3.
double logarithmTo(double x, double base) {
  const double quotient = logarithmOf(x) / logarithmOf(base);
  const double whole = std::floor(quotient + 0.5);
  return whole - whole == 0.0 && power(base, whole) == x ? whole : quotient;
}
double decimalLogarithm(double x) {
  return logarithmTo(x, 10.0);
}

int logarithm(lua_State* lua) {
  const double x = luaL_checknumber(lua, 1);
  lua_pushnumber(lua, lua_isnoneornil(lua, 2) ? logarithmOf(x) : logarithmTo(x, luaL_checknumber(lua, 2)));
  return 1;
}

int splitWhole(lua_State* lua) {
  const double x = luaL_checknumber(lua, 1);
  const double whole = std::trunc(x);
  lua_pushnumber(lua, whole);
  lua_pushnumber(lua, x == whole ? 0.0 : x - whole);
  return 2;
}

int splitExponent(lua_State* lua) {
  int exponent = 0;
  lua_pushnumber(lua, std::frexp(luaL_checknumber(lua, 1), &exponent));
  lua_pushinteger(lua, exponent);
  return 2;
}

int joinExponent(lua_State* lua) {
  const double x = luaL_checknumber(lua, 1);
  lua_pushnumber(lua, std::ldexp(x, luaL_checkint(lua, 2)));
  return 1;
}

template <bool Smallest>
int extreme(lua_State* lua) {
  double result = luaL_checknumber(lua, 1);
  const int count = lua_gettop(lua);
  for (int i = 2; i <= count; ++i) {
    const double value = luaL_checknumber(lua, i);
    if (Smallest ? value < result : value > result) result = value;
  }
  lua_pushnumber(lua, result);
  return 1;
}

/// One draw whatever the arguments: none for [0, 1), m for 1..m, m and n for m..n.
int randomNumber(lua_State* lua) {
  const int count = lua_gettop(lua);
  const double low = count >= 2 ? std::floor(luaL_checknumber(lua, 1)) : 1.0;
  const double high = count >= 1 ? std::floor(luaL_checknumber(lua, count >= 2 ? 2 : 1)) : 1.0;
  if (count >= 1 && !(low <= high)) return raise(lua, "math.random: the interval %f to %f is empty", low, high);
  const double drawn = SandboxState::of(lua).random.next() * 0x1p-32;
  lua_pushnumber(lua, count == 0 ? drawn : low + std::floor(drawn * (high - low + 1.0)));
  return 1;
}

int randomSeed(lua_State* lua) {
  const double seed = luaL_checknumber(lua, 1);
  SandboxState::of(lua).random = Random(mixSeed(__builtin_bit_cast(std::uint64_t, seed == 0.0 ? 0.0 : seed), 1));
  return 0;
}

const luaL_Reg kFunctions[] = {{"abs", unary<absolute>},
                               {"acos", unary<arcCosineOf>},
                               {"asin", unary<arcSineOf>},
                               {"atan", unary<arcTangentOfOne>},
                               {"atan2", binary<arcTangentOf>},
                               {"ceil", unary<ceilingOf>},
                               {"cos", unary<cosineOf>},
                               {"cosh", unary<hyperbolicCosine>},
                               {"deg", unary<toDegrees>},
                               {"exp", unary<exponentialOf>},
                               {"floor", unary<floorOf>},
                               {"fmod", binary<remainderOf>},
                               {"frexp", splitExponent},
                               {"ldexp", joinExponent},
                               {"log", logarithm},
                               {"log10", unary<decimalLogarithm>},
                               {"max", extreme<false>},
                               {"min", extreme<true>},
                               {"modf", splitWhole},
                               {"pow", binary<power>},
                               {"rad", unary<toRadians>},
                               {"random", randomNumber},
                               {"randomseed", randomSeed},
                               {"sin", unary<sineOf>},
                               {"sinh", unary<hyperbolicSine>},
                               {"sqrt", unary<rootOf>},
                               {"tan", unary<tangentOf>},
                               {"tanh", unary<hyperbolicTangent>},
                               {nullptr, nullptr}};

}  // namespace

void addMath(lua_State* lua) {
  lua_newtable(lua);
  luaL_setfuncs(lua, kFunctions, 0);
  lua_pushnumber(lua, kPiDouble);
  lua_setfield(lua, -2, "pi");
  lua_pushnumber(lua, __builtin_inf());
  lua_setfield(lua, -2, "huge");
  lua_setfield(lua, -2, "math");
}

}  // namespace brittle::script
