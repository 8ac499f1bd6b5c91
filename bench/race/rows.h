#pragma once

#include <string>
#include <vector>

#include "bench/race/arena.h"

namespace plumb::bench {

/// Each registers its benchmarks, whose names are TABLE/MESH or TABLE/MESH/RAYS. One iteration of a benchmark is one
/// round, in which every contestant has its turn; so what else the machine does falls on all of them. What a row says
/// is in its counters, by the names below.
void register_trace_rows(const std::vector<std::string>& meshes, const RaceSize& size);
void register_batch_rows(const std::vector<std::string>& meshes, const RaceSize& size);
void register_thread_rows(const std::vector<std::string>& meshes, const RaceSize& size);
void register_build_rows(const std::vector<std::string>& meshes, const RaceSize& size);
void register_growth_rows(const RaceSize& size);
/// Reports an error where POV-Ray is missing.
void register_frame_row(const RaceSize& size);

/// The names of the tables, in the order in which they are printed.
inline constexpr const char* kTrace = "trace";
inline constexpr const char* kBatch = "batch";
inline constexpr const char* kBuild = "build";
inline constexpr const char* kThreads = "threads";
inline constexpr const char* kGrowth = "growth";
inline constexpr const char* kFrameTable = "frame";

/// Names of counters: "of" a contestant.
inline std::string of(std::string_view what, std::string_view peer) {
  return std::string(what) + " of " + std::string(peer);
}
inline constexpr const char* kSpeed = "Mrays/s";           ///< median
inline constexpr const char* kRatio = "ratio";             ///< median over the rounds of its speed by the first one's
inline constexpr const char* kDiffers = "differs";         ///< share of rays
inline constexpr const char* kEscapes = "escapes";         ///< share of rays that miss or go on to a farther surface
inline constexpr const char* kScaling = "scaling";         ///< wall time of one thread by that of two
inline constexpr const char* kCpuScaling = "cpu scaling";  ///< CPU time of one thread by that of the slower of two
inline constexpr const char* kCpu1 = "cpu ms 1";           ///< of a build by one thread
inline constexpr const char* kCpu2 = "cpu ms 2";           ///< by two
inline constexpr const char* kCaller2 = "caller ms 2";     ///< of its calling thread alone
inline constexpr const char* kWall1 = "wall ms 1";
inline constexpr const char* kWall2 = "wall ms 2";
inline constexpr const char* kBytes = "bytes/triangle";
inline constexpr const char* kFrame = "cpu s";         ///< of a process
inline constexpr const char* kNanoseconds = "ns/ray";  ///< followed by the number of triangles

}  // namespace plumb::bench
