// make_library_meshes DIR: writes the generated meshes of the scene library into a folder that exists.

#include <exception>
#include <filesystem>
#include <iostream>

#include "meshes/formats/write_msh.h"
#include "meshes/generators/icosphere.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: make_library_meshes DIR\n";
    return 2;
  }
  try {
    plumb::write_msh(plumb::icosphere(2), std::filesystem::path(argv[1]) / "icosphere320.msh");
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
  return 0;
}
