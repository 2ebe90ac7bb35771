#include "Detail/smTransferStage.h"

#include "smOpenGL.h"

namespace sm
{
namespace
{
/// Smallest size of the memory: a small part's work lists have a third of it.
constexpr std::size_t MinCapacity = std::size_t{ 1 } << 19;
/// Alignment of the memory of an upload.
constexpr std::size_t Alignment = 64;
/// Nanoseconds after which waiting begins anew.
constexpr unsigned long long WaitNanoseconds = 1000000000ull;

/// Waits until the GPU has executed all commands.
void WaitForCopies()
{
  const GLsync fence = GL::FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  GLenum state = GL_TIMEOUT_EXPIRED;
  while (state == GL_TIMEOUT_EXPIRED)
  {
    state = GL::ClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, WaitNanoseconds);
  }
  GL::DeleteSync(fence);
}
}

bool TransferStage::Map(std::size_t bytes)
{
  if (!GL::BufferStorage)
  {
    return false;
  }
  // The driver keeps the memory until pending copies have read it.
  this->Free();
  this->Capacity = MinCapacity;
  while (this->Capacity < bytes)
  {
    this->Capacity *= 2;
  }
  const auto size = static_cast<GLsizeiptr>(this->Capacity);
  constexpr GLbitfield flags = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
  GLuint name = 0;
  GL::GenBuffers(1, &name);
  GL::BindBuffer(GL_COPY_READ_BUFFER, name);
  GL::BufferStorage(GL_COPY_READ_BUFFER, size, nullptr, flags | GL_CLIENT_STORAGE_BIT);
  void* memory = GL::MapBufferRange(GL_COPY_READ_BUFFER, 0, size, flags);
  if (!GL::TakeError().empty() || !memory)
  {
    GL::DeleteBuffers(1, &name);
    return false;
  }
  this->Name = name;
  this->Memory = static_cast<unsigned char*>(memory);
  this->Begin = this->Bytes = 0;
  return true;
}

void TransferStage::Free()
{
  if (this->Name != 0)
  {
    GL::DeleteBuffers(1, &this->Name);
    this->Name = 0;
    this->Memory = nullptr;
  }
}

void* TransferStage::BeginUpload(std::size_t bytes)
{
  if (bytes > MaximumBytes)
  {
    return nullptr;
  }
  if ((!this->Memory || bytes > this->Capacity) && !this->Map(bytes))
  {
    return nullptr;
  }
  this->Begin = (this->Begin + this->Bytes + Alignment - 1) / Alignment * Alignment;
  if (this->Begin + bytes > this->Capacity)
  {
    WaitForCopies();
    this->Begin = 0;
  }
  this->Bytes = bytes;
  return this->Memory + this->Begin;
}

void TransferStage::Upload(unsigned int buffer, std::size_t offset)
{
  GL::BindBuffer(GL_COPY_READ_BUFFER, this->Name);
  GL::BindBuffer(GL_COPY_WRITE_BUFFER, buffer);
  GL::CopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(this->Begin),
    static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(this->Bytes));
}
}
