#!/bin/sh
# Mesa 22.3.6 (Debian 12), llvmpipe: a shader's invocation makes 65,535 iterations of loops, of all its loops together; then every loop ends, and
# the invocation goes on with what it has. There is no error. A sum over a large block is a part of it, and looks like a sum.
# Guess: a loop whose end is known runs to its end, or the context is lost as it is on GPUs with a watchdog.
# Seen: 65,535 of 90,000 iterations in one loop, and 65,100 of 300 times 300, that is 217 rows: both loops count.
# Needs: apt-get of Debian 12, gcc, the C library. Installs nothing; fails if the behaviour or the version changes.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version=22.3.6-1+deb12u2
needed=$(apt-cache depends --recurse --no-recommends --no-suggests --no-conflicts --no-breaks --no-replaces --no-enhances \
  libegl-mesa0 libgl1-mesa-dri libegl-dev libgl-dev libopengl-dev | grep -E '^[a-z]' | sort -u |
  grep -vE '^(libc6|libc-dev-bin|libcrypt1|libgcc-s1|gcc-12-base|libstdc\+\+6|linux-libc-dev|perl.*|debconf.*|dpkg|tar|install-info|x11-common|lsb-base|.*-dev-bin)$')
apt-get download -qq "libegl-mesa0=$version" "libgl1-mesa-dri=$version" "libglapi-mesa=$version" "libgbm1=$version" \
  $(echo "$needed" | grep -vE '^(libegl-mesa0|libgl1-mesa-dri|libglapi-mesa|libgbm1)$') 2>/dev/null
for package in *.deb; do
  dpkg -x "$package" root
done
cat >loops.c <<'END'
#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <GL/gl.h>
#include <GL/glext.h>
#include <stdio.h>
#include <string.h>

/* The first invocation counts in one loop, the second one in two. What is added comes from a buffer. */
static const char* const text = "#version 430\n"
                                "layout(local_size_x = 1) in;\n"
                                "layout(std430, binding = 0) buffer Numbers { uint numbers[3]; };\n"
                                "uniform uint rows;\n"
                                "uniform uint columns;\n"
                                "void main()\n"
                                "{\n"
                                "  uint count = 0u;\n"
                                "  if (gl_GlobalInvocationID.x == 0u)\n"
                                "    for (uint i = 0u; i < rows * columns; ++i)\n"
                                "      count += numbers[2];\n"
                                "  else\n"
                                "    for (uint i = 0u; i < rows; ++i)\n"
                                "      for (uint k = 0u; k < columns; ++k)\n"
                                "        count += numbers[2];\n"
                                "  numbers[gl_GlobalInvocationID.x] = count;\n"
                                "}\n";

int main(void)
{
  const EGLint attributes[] = { EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE };
  GLuint numbers[3] = { 0u, 0u, 1u };
  GLuint buffer;
  const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  eglInitialize(display, NULL, NULL);
  eglBindAPI(EGL_OPENGL_API);
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, eglCreateContext(display, (EGLConfig)0, EGL_NO_CONTEXT, attributes)))
  {
    printf("no OpenGL context\n");
    return 2;
  }
  const GLuint shader = glCreateShader(GL_COMPUTE_SHADER);
  glShaderSource(shader, 1, &text, NULL);
  glCompileShader(shader);
  const GLuint program = glCreateProgram();
  glAttachShader(program, shader);
  glLinkProgram(program);
  glUseProgram(program);
  glUniform1ui(glGetUniformLocation(program, "rows"), 300u);
  glUniform1ui(glGetUniformLocation(program, "columns"), 300u);
  glGenBuffers(1, &buffer);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer);
  glBufferData(GL_SHADER_STORAGE_BUFFER, sizeof numbers, numbers, GL_DYNAMIC_COPY);
  glDispatchCompute(2, 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof numbers, numbers);
  printf("%s, %s\n", (const char*)glGetString(GL_RENDERER), (const char*)glGetString(GL_VERSION));
  printf("one loop of 90000 iterations: %u; 300 times 300: %u; glGetError: %u\n", numbers[0], numbers[1], glGetError());
  return numbers[0] == 65535u && numbers[1] == 65100u && strstr((const char*)glGetString(GL_VERSION), "22.3.6") ? 0 : 1;
}
END
libraries=$folder/root/usr/lib/x86_64-linux-gnu
gcc -DEGL_NO_X11 -I root/usr/include loops.c -o loops -L "$libraries" -lEGL -lOpenGL -Wl,-rpath-link,"$libraries:$folder/root/lib/x86_64-linux-gnu"
EGL_PLATFORM=surfaceless LIBGL_ALWAYS_SOFTWARE=1 LIBGL_DRIVERS_PATH="$libraries/dri" \
  __EGL_VENDOR_LIBRARY_DIRS="$folder/root/usr/share/glvnd/egl_vendor.d" LD_LIBRARY_PATH="$libraries:$folder/root/lib/x86_64-linux-gnu" ./loops
