# Settings that hold for every target: language, warnings, sanitizers, floating point, where programs go.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
# The shared libraries of tools/kernels hold the static ones.
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

option(PLUMB_WERROR "Treat warnings as errors" OFF)
set(PLUMB_SANITIZE "" CACHE STRING "Sanitizers to build with, as -fsanitize= takes them")
set(PLUMB_SHARED "${PROJECT_SOURCE_DIR}/../shared" CACHE PATH "Folder of real scenes and meshes (course/, meshes/, flip/)")

find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE}")
endif()

# Absent, its tests are not registered; present but incomplete, they fail.
cmake_path(ABSOLUTE_PATH PLUMB_SHARED BASE_DIRECTORY "${PROJECT_SOURCE_DIR}" NORMALIZE OUTPUT_VARIABLE PLUMB_SHARED_DIR)
if(EXISTS "${PLUMB_SHARED_DIR}")
  set(PLUMB_HAS_SHARED TRUE)
else()
  set(PLUMB_HAS_SHARED FALSE)
  message(STATUS "Real data: ${PLUMB_SHARED_DIR} does not exist, so the tests on real scenes and meshes are not registered (set PLUMB_SHARED)")
endif()

# Results must not depend on whether the compiler contracts a*b+c, so it may not.
add_compile_options(-Wall -Wextra -Wpedantic -Wshadow -Wconversion -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 reports overlaps in std::string's operator+ that are not there (GCC bug 105651).
  add_compile_options(-Wno-restrict)
endif()
if(PLUMB_WERROR)
  add_compile_options(-Werror)
endif()
if(PLUMB_SANITIZE)
  add_compile_options(-fsanitize=${PLUMB_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC 12 sees uninitialised values in libstdc++'s <regex> once it is instrumented.
    add_compile_options(-Wno-maybe-uninitialized)
  endif()
  add_link_options(-fsanitize=${PLUMB_SANITIZE})
endif()
