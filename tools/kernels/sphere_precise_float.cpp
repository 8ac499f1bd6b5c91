#include "tools/kernels/sphere_forms.h"

PLUMB_KERNEL_EXPORT const plumb_kernel* plumb_kernel_v1() {
  using namespace plumb::kernels;
  static const plumb_kernel table = KernelTable<PrimitiveKernel<Sphere<float, PreciseForm>>>::make(
      "sphere-precise-float", "ray and sphere after Haines, Gunther, Akenine-Moller 2019, in single precision",
      sphere_contract(PLUMB_FLOAT));
  return &table;
}
