/**
 * @file smOpenGL.h
 * @brief The functions of OpenGL that compute code calls, found when the first context is there; not
 * installed
 *
 * This module links no OpenGL: GL::BindBuffer() stands for glBindBuffer(). The header is not included where
 * another one of OpenGL is (GL/gl.h, VTK's loader).
 */
#ifndef smOpenGL_h
#define smOpenGL_h

#include "smRenderingComputeModule.h"

#include <GL/glcorearb.h>

#include <string>

namespace sm
{
// clang-format off
/// F(type, name) for each function gl<name>() of type PFNGL<type>PROC.
#define SM_OPENGL_FUNCTIONS(F) \
  F(ATTACHSHADER, AttachShader) \
  F(BINDBUFFER, BindBuffer) \
  F(BINDBUFFERBASE, BindBufferBase) \
  F(BINDBUFFERRANGE, BindBufferRange) \
  F(BUFFERDATA, BufferData) \
  F(BUFFERSUBDATA, BufferSubData) \
  F(CLEARBUFFERDATA, ClearBufferData) \
  F(CLIENTWAITSYNC, ClientWaitSync) \
  F(COMPILESHADER, CompileShader) \
  F(COPYBUFFERSUBDATA, CopyBufferSubData) \
  F(CREATEPROGRAM, CreateProgram) \
  F(CREATESHADER, CreateShader) \
  F(DELETEBUFFERS, DeleteBuffers) \
  F(DELETEPROGRAM, DeleteProgram) \
  F(DELETESHADER, DeleteShader) \
  F(DELETESYNC, DeleteSync) \
  F(DETACHSHADER, DetachShader) \
  F(DISPATCHCOMPUTE, DispatchCompute) \
  F(FENCESYNC, FenceSync) \
  F(FINISH, Finish) \
  F(GENBUFFERS, GenBuffers) \
  F(GETACTIVEUNIFORM, GetActiveUniform) \
  F(GETBUFFERSUBDATA, GetBufferSubData) \
  F(GETERROR, GetError) \
  F(GETINTEGER64I_V, GetInteger64i_v) \
  F(GETINTEGER64V, GetInteger64v) \
  F(GETINTEGERI_V, GetIntegeri_v) \
  F(GETINTEGERV, GetIntegerv) \
  F(GETPROGRAMINFOLOG, GetProgramInfoLog) \
  F(GETPROGRAMIV, GetProgramiv) \
  F(GETSHADERINFOLOG, GetShaderInfoLog) \
  F(GETSHADERIV, GetShaderiv) \
  F(GETSTRING, GetString) \
  F(GETSTRINGI, GetStringi) \
  F(GETUNIFORMLOCATION, GetUniformLocation) \
  F(ISBUFFER, IsBuffer) \
  F(ISPROGRAM, IsProgram) \
  F(LINKPROGRAM, LinkProgram) \
  F(MAPBUFFERRANGE, MapBufferRange) \
  F(MEMORYBARRIER, MemoryBarrier) \
  F(PROGRAMUNIFORM1D, ProgramUniform1d) \
  F(PROGRAMUNIFORM1I, ProgramUniform1i) \
  F(PROGRAMUNIFORM1UI, ProgramUniform1ui) \
  F(SHADERSOURCE, ShaderSource) \
  F(USEPROGRAM, UseProgram) \
  F(BUFFERSTORAGE, BufferStorage)
// clang-format on

struct SMRENDERINGCOMPUTE_EXPORT GL
{
#define SM_DECLARE(type, name) static PFNGL##type##PROC name;
  SM_OPENGL_FUNCTIONS(SM_DECLARE)
#undef SM_DECLARE

  /// Finds the functions that no earlier call has found, by getAddress("glBindBuffer"). A context must be
  /// current. BufferStorage is null without version 4.4 and without its extension; other functions that the
  /// driver does not have may have an address, too: ask for the version. Thread safe.
  static void Load(void* (*getAddress)(const char* name));

  /// Removes pending GL errors of other code. The number of calls is limited, because a lost context may
  /// report errors for ever.
  static void DrainErrors();
  /// Returns the name of the first pending error, or an empty text, and removes all others.
  static std::string TakeError();
};
}

#endif
