#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

#include "meshes/triangle_mesh.h"

namespace plumb {

/// How much may be allocated at one time to read a file of S bytes: per_byte * S + kConstantBytes.
struct AllocationBound {
  std::size_t per_byte;
};

/// What does not grow with the file: streams with their buffers of 8 KiB, the text of an error, which quotes at most 40
/// bytes of the file.
inline constexpr std::size_t kConstantBytes = 16384;

/// Reads the bytes as the content of a file of this name (`x.msh`; the ending names the reader). Ends the program with
/// a message if that throws anything but InputError, if more bytes are live at any one time than the bound allows, or
/// if the mesh breaks a promise of read_mesh: indices in range, finite numbers, one normal and one texture coordinate a
/// vertex or none. Returns whether the bytes were read as a mesh, which is then in `mesh`.
///
/// At the program's end prints the largest share of the bound that a file took, and how many files were read as meshes.
bool read_under_fuzz(const std::filesystem::path& file, AllocationBound bound, const std::uint8_t* data,
                     std::size_t size, TriangleMesh& mesh);

/// A file of this process with this ending, in memory where the system has a place for it; removed when the program
/// ends.
const std::filesystem::path& scratch_file(const std::string& ending);

}  // namespace plumb
