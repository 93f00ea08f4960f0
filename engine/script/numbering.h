// script/numbering.h - numbers for functions and for the libraries' tables: those that exist after the sources were
// loaded have the same numbers in every sandbox that loaded the same sources, so a number stands for one in a snapshot.
// All in protected mode only. Internal to engine/script.
#pragma once

#include <lua.hpp>

namespace brittle::script {

/// Remembers the globals as they are now as the built-in ones.
void rememberBuiltins(lua_State* lua);
/// Whether the value on top of the stack is the built-in of this name.
bool isBuiltin(lua_State* lua, const char* name);
/// Numbers every function reachable from the globals that has no number yet.
void numberFunctions(lua_State* lua);

/// Makes these two all that is on the stack: 1 function or library table -> number, 2 the reverse.
void pushNumberingTables(lua_State* lua);
/// Pushes the table of built-ins: name -> value.
void pushBuiltins(lua_State* lua);

}  // namespace brittle::script
