/**
 * @file smAllocatedBytes.h
 * @brief How many bytes a program has allocated
 */
#ifndef smAllocatedBytes_h
#define smAllocatedBytes_h

namespace smtest
{
/// Bytes that the program that links smAllocatedBytes.cxx and its libraries have allocated by `new` since the
/// first call, freed or not.
long long GetAllocatedBytes();
}

#endif
