# plumb_library(NAME SOURCES... HEADERS... [PUBLIC libs...] [PRIVATE libs...])
#   The static library plumb_NAME with the alias plumb::NAME. The ci preset compiles each header alone; one whose source includes it first
#   (the test `layers` sees to that) is compiled alone with that.
function(plumb_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;HEADERS;PUBLIC;PRIVATE" ${ARGN})
  add_library(plumb_${name} STATIC ${arg_SOURCES})
  add_library(plumb::${name} ALIAS plumb_${name})
  set(sourceless ${arg_HEADERS})
  foreach(source IN LISTS arg_SOURCES)
    cmake_path(REPLACE_EXTENSION source h)
    list(REMOVE_ITEM sourceless "${source}")
  endforeach()
  target_sources(plumb_${name} PUBLIC FILE_SET sourceless TYPE HEADERS BASE_DIRS "${PROJECT_SOURCE_DIR}" FILES ${sourceless})
  target_link_libraries(plumb_${name} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})
endfunction()

# plumb_tests(NAME SOURCES... [LIBRARIES libs...] [DEFINES ...] [MANY_ALLOCATIONS])
#   One GoogleTest program NAME_test; each of its tests is a test of ctest. MANY_ALLOCATIONS: exact numbers live on the heap, and the
#   sanitizer's slow way to trace allocations, which CMakePresets.json asks for to know whose leak is whose, would take minutes.
function(plumb_tests name)
  cmake_parse_arguments(arg "MANY_ALLOCATIONS" "" "SOURCES;LIBRARIES;DEFINES" ${ARGN})
  find_package(GTest REQUIRED)
  add_executable(${name}_test ${arg_SOURCES})
  target_link_libraries(${name}_test PRIVATE ${arg_LIBRARIES} GTest::gmock_main)
  target_compile_definitions(${name}_test PRIVATE
    PLUMB_SOURCE_DIR="${PROJECT_SOURCE_DIR}" PLUMB_SHARED_DIR="${PLUMB_SHARED_DIR}"
    PLUMB_PROGRAM="${PROJECT_BINARY_DIR}/bin/plumb" ${arg_DEFINES})
  set(environment "")
  if(arg_MANY_ALLOCATIONS)
    set(environment ENVIRONMENT "ASAN_OPTIONS=fast_unwind_on_malloc=1")
  endif()
  include(GoogleTest)
  gtest_discover_tests(${name}_test TEST_PREFIX "${name}/" DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 600 ${environment})
endfunction()

# plumb_kinds(OUT TYPE HEADER NAMESPACE_VARIABLE FILES...)
#   Writes OUT, a table with a pointer to the one constant of each kind file. The constant of
#   `some_thing.cpp` is `some_thing_kind`. Static registrars would be dropped by the linker unseen.
function(plumb_kinds out type header table)
  set(declarations "")
  set(entries "")
  foreach(file IN LISTS ARGN)
    cmake_path(GET file STEM stem)
    string(APPEND declarations "extern const ${type} ${stem}_kind;\n")
    string(APPEND entries "    &${stem}_kind,\n")
  endforeach()
  list(LENGTH ARGN count)
  file(CONFIGURE OUTPUT "${out}" CONTENT
"// Written by CMake from the files of the folder; do not edit.
#include \"${header}\"

#include <array>

namespace plumb {
${declarations}
namespace {
const std::array<const ${type}*, ${count}> kKinds{
${entries}};
}  // namespace

std::span<const ${type}* const> ${table}() { return kKinds; }
}  // namespace plumb
" @ONLY)
endfunction()

# plumb_sources(OUT_SOURCES OUT_HEADERS OUT_TESTS FOLDERS...)
#   The .cpp, .h and _test.cpp files of the folders, relative to the current one; without headers that only tests include.
function(plumb_sources sources headers tests)
  foreach(folder IN LISTS ARGN)
    file(GLOB cpp CONFIGURE_DEPENDS RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" "${folder}/*.cpp")
    file(GLOB h CONFIGURE_DEPENDS RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" "${folder}/*.h")
    list(APPEND all_cpp ${cpp})
    list(APPEND all_h ${h})
  endforeach()
  set(found_tests ${all_cpp})
  list(FILTER all_cpp EXCLUDE REGEX "_test\\.cpp$")
  list(FILTER all_h EXCLUDE REGEX "_for_tests\\.h$")  # they need what a test program is told, and GoogleTest
  list(FILTER found_tests INCLUDE REGEX "_test\\.cpp$")
  set(${sources} ${all_cpp} PARENT_SCOPE)
  set(${headers} ${all_h} PARENT_SCOPE)
  set(${tests} ${found_tests} PARENT_SCOPE)
endfunction()
