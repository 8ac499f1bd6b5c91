// The process that a kernel runs in: `plumb-kernel-host LIBRARY`, with the line to who asks as standard input.
#include "conformance/subject/kernel_host.h"

#include <cstdio>

int main(int argc, char** argv) {
  if (argc == 2) return plumb::run_kernel_host(argv[1], 0);
  std::fputs("plumb-kernel-host LIBRARY: started by plumb, for a kernel to run in\n", stderr);
  return 2;
}
