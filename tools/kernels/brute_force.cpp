#include "tools/kernels/moller_trumbore.h"

PLUMB_KERNEL_EXPORT const plumb_kernel* plumb_kernel_v1() {
  using namespace plumb::kernels;
  static const plumb_kernel table = KernelTable<PrimitiveKernel<MollerTrumbore<double>, EveryPrimitive>>::make(
      "brute-force", "Moller-Trumbore in double precision, scalar, every triangle for every ray",
      moller_trumbore_contract(PLUMB_DOUBLE));
  return &table;
}
