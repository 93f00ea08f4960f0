# Helpers of the top-level CMakeLists: a library per folder, headers that stand outside a cross compiler's search path,
# and the Debian packages with the reason each was chosen.

# brittle_target(engine/math OUT): engine/math -> brittle_engine_math
function(brittle_target folder out)
  string(REPLACE "/" "_" name ${folder})
  set(${out} brittle_${name} PARENT_SCOPE)
endfunction()

# brittle_effect(Joints FILES... [INSTEAD FILE]): an option BRITTLE_EFFECT_JOINTS, on; off, its files (patterns) are not compiled,
# but FILE, which answers in their place, is. engine/effects/has/joints.h says which: a header for each effect, so that a
# build without one compiles little anew.
function(brittle_effect name)
  cmake_parse_arguments(ARG "" "INSTEAD" "" ${ARGN})
  string(TOUPPER ${name} option)
  option(BRITTLE_EFFECT_${option} "The module of the effect ${name}" ON)
  set_property(GLOBAL APPEND_STRING PROPERTY BRITTLE_EFFECT_MODULES "${name} ")
  set(left_out ${ARG_INSTEAD})
  set(BRITTLE_HAS true)
  if(NOT BRITTLE_EFFECT_${option})
    set(left_out ${ARG_UNPARSED_ARGUMENTS})
    set(BRITTLE_HAS false)
    set_property(GLOBAL APPEND_STRING PROPERTY BRITTLE_NOT_BUILT " && effect != Effect::${name}")
  endif()
  if(left_out)
    file(GLOB files ${left_out})
    set_property(GLOBAL APPEND PROPERTY BRITTLE_LEFT_OUT ${files})
  endif()
  set(BRITTLE_MODULE ${name})
  string(REGEX REPLACE "([a-z])([A-Z])" "\\1_\\2" BRITTLE_FILE ${name})
  string(TOLOWER ${BRITTLE_FILE} BRITTLE_FILE)
  configure_file(${PROJECT_SOURCE_DIR}/engine/effects/has.h.in ${PROJECT_BINARY_DIR}/generated/engine/effects/has/${BRITTLE_FILE}.h)
endfunction()

# Which modules there are, for who asks while the program runs.
function(brittle_write_built)
  get_property(BRITTLE_NOT_BUILT GLOBAL PROPERTY BRITTLE_NOT_BUILT)
  brittle_target(engine/effects target)
  configure_file(${PROJECT_SOURCE_DIR}/engine/effects/built.cpp.in ${PROJECT_BINARY_DIR}/generated/engine/effects/built.cpp)
  target_sources(${target} PRIVATE ${PROJECT_BINARY_DIR}/generated/engine/effects/built.cpp)
endfunction()

# One static library from every .cpp of a folder; a folder of headers alone becomes an interface library.
function(brittle_library folder)
  cmake_parse_arguments(ARG "" "" "DEPENDS;LINK" ${ARGN})
  brittle_target(${folder} target)
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp)
  get_property(left_out GLOBAL PROPERTY BRITTLE_LEFT_OUT)
  if(left_out)
    list(REMOVE_ITEM sources ${left_out})
  endif()
  set(kind PUBLIC)
  if(sources)
    add_library(${target} STATIC ${sources})
    brittle_precompile(${target})
  else()
    add_library(${target} INTERFACE)
    set(kind INTERFACE)
  endif()
  target_include_directories(${target} ${kind} ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated)
  target_link_libraries(${target} ${kind} ${ARG_LINK})
  foreach(dependency ${ARG_DEPENDS})
    brittle_target(${dependency} name)
    target_link_libraries(${target} ${kind} ${name})
  endforeach()
endfunction()

# What a test spends its time in is the library it tests; the tests themselves are two fifths of the build at -O2.
set(BRITTLE_TEST_OPTIONS $<$<CONFIG:Release>:-O1>)

# Precompiled: the standard library, Eigen, and for tests GoogleTest; never a header of ours.
function(brittle_precompile target)
  cmake_parse_arguments(ARG "TEST" "" "" ${ARGN})
  set(headers <Eigen/Core> <Eigen/Geometry> <algorithm> <array> <cstdint> <functional> <map> <memory> <span> <string> <string_view> <vector>)
  set(precompiled brittle_precompiled)
  set(libraries Eigen3::Eigen)
  if(ARG_TEST)
    list(APPEND headers <gmock/gmock.h> <gtest/gtest.h>)
    set(precompiled brittle_precompiled_tests)
    set(libraries Eigen3::Eigen GTest::gtest GTest::gmock)
  endif()
  if(NOT TARGET ${precompiled})
    file(WRITE ${PROJECT_BINARY_DIR}/precompiled.cpp "")
    add_library(${precompiled} OBJECT ${PROJECT_BINARY_DIR}/precompiled.cpp)
    target_link_libraries(${precompiled} PRIVATE ${libraries})
    target_compile_options(${precompiled} PRIVATE $<$<BOOL:${ARG_TEST}>:${BRITTLE_TEST_OPTIONS}>)
    target_precompile_headers(${precompiled} PRIVATE ${headers})
  endif()
  target_link_libraries(${target} PRIVATE ${libraries})
  target_precompile_headers(${target} REUSE_FROM ${precompiled})
  if(ARG_TEST)
    target_compile_options(${target} PRIVATE ${BRITTLE_TEST_OPTIONS})
  endif()
endfunction()

# A header-only package in /usr/include: a cross compiler must not see the rest of that folder, so it gets a folder of its own.
function(brittle_header variable header package)
  find_path(${variable}_DIR ${header} HINTS /usr/include NO_CMAKE_FIND_ROOT_PATH)
  if(NOT ${variable}_DIR)
    message(FATAL_ERROR "${header} not found: apt-get install ${package} (tools/setup installs everything)")
  endif()
  string(TOLOWER ${variable} name)
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/headers/${name})
  file(CREATE_LINK ${${variable}_DIR}/${header} ${PROJECT_BINARY_DIR}/headers/${name}/${header} SYMBOLIC)
  add_library(${name} INTERFACE)
  target_include_directories(${name} SYSTEM INTERFACE ${PROJECT_BINARY_DIR}/headers/${name})
endfunction()

# The packages beyond the simulation's own, each with why it was chosen.
macro(brittle_find_packages)
  find_package(PkgConfig REQUIRED)
  find_package(SDL2 REQUIRED)      # window, input, audio device: on every platform we aim at
  find_package(pugixml REQUIRED)   # level XML: fast, keeps offsets for file:line, accepts duplicate attributes
  find_package(GTest REQUIRED)     # tests
  find_package(benchmark REQUIRED) # tools/bench
  find_package(CLI11 REQUIRED)     # command lines with --help: header-only
  find_library(voro voro++ REQUIRED) # tests alone: another's cutter of convexes, of another kind, to compare ours with
  pkg_check_modules(egl REQUIRED IMPORTED_TARGET egl)          # off-screen contexts without a display
  pkg_check_modules(osmesa REQUIRED IMPORTED_TARGET osmesa)    # off-screen contexts without EGL
  pkg_check_modules(gles REQUIRED IMPORTED_TARGET glesv2)      # GLES 3 headers (functions are loaded at run time)
  pkg_check_modules(stb REQUIRED IMPORTED_TARGET stb)          # PNG, font rasteriser: header-only
  pkg_check_modules(lua REQUIRED IMPORTED_TARGET lua5.2)       # the language and version of the community's levels
  pkg_check_modules(zlib REQUIRED IMPORTED_TARGET zlib)        # .gz segments, replay compression
  pkg_check_modules(imgui REQUIRED IMPORTED_TARGET imgui)      # the sandbox's sliders: immediate mode, draws what we hand it
  foreach(package egl osmesa stb lua zlib imgui)
    add_library(${package} ALIAS PkgConfig::${package})
  endforeach()
  add_library(brittle_gles_headers INTERFACE)
  target_include_directories(brittle_gles_headers SYSTEM INTERFACE ${gles_INCLUDE_DIRS})
endmacro()

# One test program per folder: tests/FOLDER/test_*.cpp. Further arguments: what it links beside the folder's own library.
# A suite whose name ends in Long takes minutes: FOLDER/long, labelled `long`, runs those, and only `tools/test --full` runs it.
function(brittle_test folder)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/${folder}/*.cpp)
  get_property(left_out GLOBAL PROPERTY BRITTLE_LEFT_OUT)
  if(left_out)
    list(REMOVE_ITEM sources ${left_out})
  endif()
  if(NOT sources)
    return()
  endif()
  string(REPLACE "/" "_" name ${folder})
  add_executable(test_${name} ${sources})
  brittle_precompile(test_${name} TEST)
  target_compile_definitions(test_${name} PRIVATE BRITTLE_SOURCE_DIR="${PROJECT_SOURCE_DIR}" BRITTLE_BINARY_DIR="${PROJECT_BINARY_DIR}")
  target_link_libraries(test_${name} PRIVATE GTest::gtest_main GTest::gmock ${ARGN})
  add_test(NAME ${folder} COMMAND test_${name} --gtest_filter=-*Long.*:*Long/* WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
  foreach(source ${sources})
    file(STRINGS ${source} long_suite REGEX "^(TEST|INSTANTIATE)[A-Z_]*[(].*Long," LIMIT_COUNT 1)
    if(long_suite AND NOT TEST ${folder}/long)
      add_test(NAME ${folder}/long COMMAND test_${name} --gtest_filter=*Long.*:*Long/* WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
      set_tests_properties(${folder}/long PROPERTIES LABELS long)
    endif()
  endforeach()
endfunction()

# One program per folder of tools/: every .cpp in it, linked with the libraries named. TEST: its sources are tests.
function(brittle_program name)
  cmake_parse_arguments(ARG "TEST" "" "" ${ARGN})
  set(kind)
  if(ARG_TEST)
    set(kind TEST)
  endif()
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tools/${name}/*.cpp)
  add_executable(${name} ${sources})
  brittle_precompile(${name} ${kind})
  target_link_libraries(${name} PRIVATE ${ARG_UNPARSED_ARGUMENTS})
  # A tool is many small scenes, each with a kSpeed of its own: its files are compiled one by one.
  set_target_properties(${name} PROPERTIES UNITY_BUILD OFF)
endfunction()
