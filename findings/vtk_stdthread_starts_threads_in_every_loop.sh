#!/bin/sh
# VTK 9.1 (Debian 12): every vtkSMPTools::For() with the backend STDThread starts its threads anew, and joins them at its end.
# Guess: a backend of threads keeps a pool, so that 100 loops with 2 threads run on 2 threads.
# Seen: 200 threads for 100 loops. With 16 threads a loop took about a millisecond before it did anything.
# Needs: apt-get of Debian 12, g++, the C++ library. Installs nothing; fails if the behaviour or the version changes.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version=9.1.0+really9.1.0+dfsg2-5+deb12u1
apt-get download -qq "libvtk9-dev=$version" "libvtk9.1=$version" libtbb12=2021.8.0-2+deb12u1 2>/dev/null
for package in *.deb; do
  dpkg -x "$package" root
done
cat >loops.cxx <<'END'
#include <vtkSMPTools.h>
#include <vtkVersion.h>

#include <atomic>
#include <cstdio>
#include <mutex>
#include <sched.h>
#include <set>
#include <sys/syscall.h>
#include <unistd.h>

int main()
{
  constexpr int threads = 2;
  constexpr int loops = 100;
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(threads);
  std::mutex mutex;
  std::set<long> seen;
  for (int i = 0; i < loops; ++i)
  {
    // Each part waits for the other one, so that both threads take part in every loop.
    std::atomic<int> arrived{ 0 };
    vtkSMPTools::For(0, threads, 1,
      [&](vtkIdType, vtkIdType)
      {
        ++arrived;
        while (arrived < threads)
        {
          sched_yield();
        }
        const std::lock_guard<std::mutex> lock(mutex);
        seen.insert(syscall(SYS_gettid));
      });
  }
  std::printf("VTK %s: %d loops with %d threads ran on %zu threads\n", vtkVersion::GetVTKVersion(), loops, threads, seen.size());
  return seen.size() == static_cast<std::size_t>(threads) * loops ? 0 : 1;
}
END
libraries=root/usr/lib/x86_64-linux-gnu
g++ -std=c++17 -O1 -I root/usr/include/vtk-9.1 loops.cxx -o loops -L "$libraries" -lvtkCommonCore-9.1 -lvtksys-9.1 -l:libtbb.so.12 -w -pthread \
  -Wl,-rpath-link,"$libraries"
LD_LIBRARY_PATH=$libraries ./loops
