/*
 * A library for LD_PRELOAD: counts dispatches, read-backs and bytes of a process, and the seconds in which it
 * waits for OpenGL. CountDispatches.py compiles it and calls CountOpenGL().
 *
 * OpenGL's functions reach a program by symbol or by the loaders of EGL and GLX; both ways end here.
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <time.h>

typedef void (*Function)(void);
typedef unsigned int Enum;

/* Dispatches, read-backs, bytes up, bytes down, nanoseconds in dispatches and waits. */
enum
{
  Dispatches,
  ReadBacks,
  BytesUp,
  BytesDown,
  Waited,
  NumberOfCounts
};
static int64_t Counts[NumberOfCounts];

/* The times of vtkTimerLog since the last call of CountOpenGL(), and the nanoseconds of waits before each. */
enum
{
  MaxTimes = 100000
};
static double Times[MaxTimes];
static int64_t WaitedBefore[MaxTimes];
static int NumberOfTimes;

/* Writes the counts since the last call, and begins anew. */
void CountOpenGL(int64_t counts[NumberOfCounts])
{
  memcpy(counts, Counts, sizeof(Counts));
  memset(Counts, 0, sizeof(Counts));
  NumberOfTimes = 0;
}

/* vtkTimerLog::GetUniversalTime(): the ends of a stage are two of its times. */
double GetUniversalTime(void) __asm__("_ZN11vtkTimerLog16GetUniversalTimeEv");
double GetUniversalTime(void)
{
  struct timespec now;
  clock_gettime(CLOCK_REALTIME, &now);
  const double time = (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
  const int at = __atomic_fetch_add(&NumberOfTimes, 1, __ATOMIC_RELAXED);
  if (at < MaxTimes)
  {
    Times[at] = time;
    WaitedBefore[at] = Counts[Waited];
  }
  return time;
}

/* Returns the nanoseconds of waits in the stage that took `seconds`; -1 if there is none. */
int64_t CountWaits(double seconds)
{
  for (int begin = 0; begin < NumberOfTimes && begin < MaxTimes; ++begin)
  {
    for (int end = begin + 1; end < NumberOfTimes && end < MaxTimes; ++end)
    {
      if (Times[end] - Times[begin] == seconds)
      {
        return WaitedBefore[end] - WaitedBefore[begin];
      }
    }
  }
  return -1;
}

static int64_t GetNanoseconds(void)
{
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (int64_t)now.tv_sec * 1000000000 + now.tv_nsec;
}

/* Finds a function of OpenGL, EGL or GLX in the libraries of the process, also in those that Python loaded
 * for one module alone. */
static Function FindNext(const char* name)
{
  static const char* const Libraries[] = { "libGL.so.1", "libOpenGL.so.0", "libEGL.so.1", "libGLX.so.0" };
  for (size_t i = 0; i < sizeof(Libraries) / sizeof(*Libraries); ++i)
  {
    void* library = dlopen(Libraries[i], RTLD_LAZY | RTLD_NOLOAD);
    const Function function = library ? (Function)dlsym(library, name) : NULL;
    if (function)
    {
      return function;
    }
  }
  return NULL;
}

/* `next` is OpenGL's own function. */
#define NEXT(function)                                                                                       \
  static __typeof__(function)* next;                                                                         \
  if (!next)                                                                                                 \
  {                                                                                                          \
    next = (__typeof__(function)*)FindNext(#function);                                                       \
  }
#define TIMED(call)                                                                                          \
  const int64_t begin = GetNanoseconds();                                                                    \
  call;                                                                                                      \
  Counts[Waited] += GetNanoseconds() - begin;

void glDispatchCompute(unsigned int x, unsigned int y, unsigned int z)
{
  NEXT(glDispatchCompute)
  ++Counts[Dispatches];
  TIMED(next(x, y, z))
}

void glGetBufferSubData(Enum target, intptr_t offset, intptr_t size, void* data)
{
  NEXT(glGetBufferSubData)
  ++Counts[ReadBacks];
  Counts[BytesDown] += size;
  TIMED(next(target, offset, size, data))
}

void glFinish(void){ NEXT(glFinish) TIMED(next()) }

void glMemoryBarrier(unsigned int barriers)
{
  NEXT(glMemoryBarrier)
  TIMED(next(barriers))
}

Enum glClientWaitSync(void* sync, unsigned int flags, uint64_t timeout)
{
  NEXT(glClientWaitSync)
  TIMED(const Enum state = next(sync, flags, timeout))
  return state;
}

/* Uploads: their seconds are the caller's. */
void glBufferData(Enum target, intptr_t size, const void* data, Enum usage)
{
  NEXT(glBufferData)
  Counts[BytesUp] += data ? size : 0;
  next(target, size, data, usage);
}

void glBufferSubData(Enum target, intptr_t offset, intptr_t size, const void* data)
{
  NEXT(glBufferSubData)
  Counts[BytesUp] += size;
  next(target, offset, size, data);
}

void glCopyBufferSubData(Enum from, Enum to, intptr_t read, intptr_t write, intptr_t size)
{
  NEXT(glCopyBufferSubData)
  Counts[BytesUp] += size;
  next(from, to, read, write, size);
}

static Function FindOwn(const char* name)
{
#define OWN(function)                                                                                        \
  {                                                                                                          \
#function, (Function)function                                                                            \
  }
  static const struct
  {
    const char* Name;
    Function Own;
  } Owns[] = { OWN(glDispatchCompute), OWN(glGetBufferSubData), OWN(glFinish), OWN(glMemoryBarrier), OWN(glClientWaitSync),
    OWN(glBufferData), OWN(glBufferSubData), OWN(glCopyBufferSubData) };
  for (size_t i = 0; i < sizeof(Owns) / sizeof(*Owns); ++i)
  {
    if (strcmp(Owns[i].Name, name) == 0)
    {
      return Owns[i].Own;
    }
  }
  return NULL;
}

#define LOADER(loader)                                                                                       \
  Function loader(const char* name)                                                                          \
  {                                                                                                          \
    NEXT(loader)                                                                                             \
    const Function own = FindOwn(name);                                                                      \
    return own ? own : next(name);                                                                           \
  }
LOADER(eglGetProcAddress)
LOADER(glXGetProcAddress)
LOADER(glXGetProcAddressARB)
