# The files of conformance/sandbox, relative to conformance/, for its CMakeLists.txt to include.

set(SANDBOX_SOURCES
  sandbox/answer_lines.cpp
  sandbox/end_processes.cpp
  sandbox/folder_size.cpp
  sandbox/harvest.cpp
  sandbox/log_capture.cpp
  sandbox/process_memory.cpp
  sandbox/process_tree.cpp
  sandbox/run_outcome.cpp
  sandbox/run_process.cpp
  sandbox/session.cpp
  sandbox/start_process.cpp
  sandbox/usage_meter.cpp
  sandbox/watched_process.cpp)

set(SANDBOX_HEADERS
  sandbox/answer_lines.h
  sandbox/end_processes.h
  sandbox/file_descriptor.h
  sandbox/folder_size.h
  sandbox/harvest.h
  sandbox/log_capture.h
  sandbox/process_memory.h
  sandbox/process_tree.h
  sandbox/run_outcome.h
  sandbox/run_process.h
  sandbox/session.h
  sandbox/start_process.h
  sandbox/temporary_folder.h
  sandbox/usage_meter.h
  sandbox/watched_process.h)

set(SANDBOX_TESTS
  sandbox/answer_lines_test.cpp
  sandbox/end_processes_test.cpp
  sandbox/folder_size_test.cpp
  sandbox/harvest_test.cpp
  sandbox/log_capture_test.cpp
  sandbox/process_memory_test.cpp
  sandbox/process_tree_test.cpp
  sandbox/run_limits_test.cpp
  sandbox/run_process_test.cpp
  sandbox/session_test.cpp
  sandbox/start_process_test.cpp
  sandbox/usage_meter_test.cpp)

# The misbehaving program of the tests. Without sanitizers, so that what it uses is what it asks for.
find_package(Threads REQUIRED)
add_executable(sandbox_subject sandbox/sandbox_subject.cpp)
set_target_properties(sandbox_subject PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/test-subjects")
target_link_libraries(sandbox_subject PRIVATE Threads::Threads)
target_compile_options(sandbox_subject PRIVATE -fno-sanitize=all)
target_link_options(sandbox_subject PRIVATE -fno-sanitize=all)
set_source_files_properties(${SANDBOX_TESTS} PROPERTIES
  COMPILE_DEFINITIONS "SANDBOX_SUBJECT=\"${CMAKE_BINARY_DIR}/test-subjects/sandbox_subject\"")
