#pragma once

#include <filesystem>

namespace plumb {

/// The life of the process that a kernel runs in: loads the library, says what it is, and answers the messages of
/// `descriptor`, a stream socket, until it is closed. Takes the descriptor; standard input is /dev/null from then on.
/// Returns the exit status: 0, also where the library was refused (which has been said on the line).
int run_kernel_host(const std::filesystem::path& library, int descriptor);

}  // namespace plumb
