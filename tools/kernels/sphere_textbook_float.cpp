#include "tools/kernels/sphere_forms.h"

PLUMB_KERNEL_EXPORT const plumb_kernel* plumb_kernel_v1() {
  using namespace plumb::kernels;
  static const plumb_kernel table = KernelTable<PrimitiveKernel<Sphere<float, TextbookForm>>>::make(
      "sphere-textbook-float", "the quadratic formula of textbooks, in single precision", sphere_contract(PLUMB_FLOAT));
  return &table;
}
