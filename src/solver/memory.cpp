#include "solver/memory.hpp"
#include <malloc.h>

namespace towform {

void give_back_memory()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

} // namespace towform
