// A library in the place of smReadersKernel that ends its process when it is asked for the kernel.
#include <cstdlib>

extern "C" __attribute__((visibility("default"))) const void* SolidMomentsGetKernel()
{
  std::abort();
}
