#pragma once

#include <mutex>

namespace plumb {

/// The right to use the readers and writers of OpenMesh, which are global objects with state: other threads wait for
/// it. While it lives, OpenMesh's message streams are silent.
class OpenMeshTurn {
 public:
  OpenMeshTurn();
  ~OpenMeshTurn();
  OpenMeshTurn(const OpenMeshTurn&) = delete;
  OpenMeshTurn& operator=(const OpenMeshTurn&) = delete;

 private:
  std::unique_lock<std::mutex> lock_;
  bool errors_were_on_, log_was_on_;
};

}  // namespace plumb
