#include "conformance/subject/kernel_subject.h"

#include "conformance/subject/kernel_caller.h"

namespace plumb {

KernelSubject::KernelSubject(const std::filesystem::path& library, const KernelOptions& options)
    : CheckedKernel(std::make_unique<KernelClient>(library, options), library) {}

LocalKernelSubject::LocalKernelSubject(const std::filesystem::path& library)
    : CheckedKernel(std::make_unique<KernelCaller>(library), library) {}

}  // namespace plumb
