#include "tools/kernels/moller_trumbore.h"

PLUMB_KERNEL_EXPORT const plumb_kernel* plumb_kernel_v1() {
  using namespace plumb::kernels;
  static const plumb_kernel table = KernelTable<PrimitiveKernel<MollerTrumbore<float>>>::make(
      "mt-float", "Moller-Trumbore in single precision, scalar, in a binary hierarchy of doubles",
      moller_trumbore_contract(PLUMB_FLOAT));
  return &table;
}
