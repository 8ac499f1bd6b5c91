#pragma once

#include <filesystem>

namespace plumb {

/// What lies beside the program that runs, whose folder is PREFIX/bin: PREFIX/share/plumb.
std::filesystem::path shipped_folder();
/// The programs with known mistakes, PREFIX/mutants; there once they were built.
std::filesystem::path shipped_mutants();
/// The texts about them.
std::filesystem::path shipped_known_mistakes();
/// Whether each of the texts has its program.
bool has_shipped_mutants();

}  // namespace plumb
