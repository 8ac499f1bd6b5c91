#include "tools/kernels/sphere_forms.h"

PLUMB_KERNEL_EXPORT const plumb_kernel* plumb_kernel_v1() {
  using namespace plumb::kernels;
  static const plumb_kernel table = KernelTable<PrimitiveKernel<Sphere<double, PreciseForm>>>::make(
      "sphere-precise-double", "ray and sphere after Haines, Gunther, Akenine-Moller 2019, in double precision",
      sphere_contract(PLUMB_DOUBLE));
  return &table;
}
