#include "tools/kernels/sphere_forms.h"

PLUMB_KERNEL_EXPORT const plumb_kernel* plumb_kernel_v1() {
  using namespace plumb::kernels;
  static const plumb_kernel table = KernelTable<PrimitiveKernel<Sphere<double, TextbookForm>>>::make(
      "sphere-textbook-double", "the quadratic formula of textbooks, in double precision",
      sphere_contract(PLUMB_DOUBLE));
  return &table;
}
