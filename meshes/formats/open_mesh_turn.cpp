#include "meshes/formats/open_mesh_turn.h"

#include <OpenMesh/Core/System/omstream.hh>

namespace plumb {
namespace {

std::mutex& the_turn() {
  static std::mutex turn;
  return turn;
}

}  // namespace

OpenMeshTurn::OpenMeshTurn()
    : lock_(the_turn()), errors_were_on_(omerr().is_enabled()), log_was_on_(omlog().is_enabled()) {
  omerr().disable();
  omlog().disable();
}

OpenMeshTurn::~OpenMeshTurn() {
  if (errors_were_on_) omerr().enable();
  if (log_was_on_) omlog().enable();
}

}  // namespace plumb
