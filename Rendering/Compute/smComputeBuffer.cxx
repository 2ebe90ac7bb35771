#include "smComputeBuffer.h"

#include "smContextResources.h"
#include "smContextScope.h"
#include "smOpenGL.h"
#include "vtkComputeContext.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <optional>
#include <utility>

namespace
{
/// Smallest size of a store: a binding of 0 bytes is an error, so an empty buffer has a small store, too.
constexpr std::size_t MinBytes = 16;

/// Stores up to this size are never replaced by smaller ones.
constexpr std::size_t SmallStore = 65536;

bool Enter(const sm::ContextResources& resources, std::optional<sm::ContextScope>& scope)
{
  if (sm::ContextScope::IsInside(resources.Context))
  {
    return true;
  }
  scope.emplace(resources.Context);
  return static_cast<bool>(*scope);
}
}

namespace sm
{
ComputeBuffer::ComputeBuffer() = default;

ComputeBuffer::ComputeBuffer(vtkComputeContext* context)
{
  if (context)
  {
    this->Resources = context->GetResources();
  }
}

ComputeBuffer::~ComputeBuffer()
{
  this->Free();
}

ComputeBuffer::ComputeBuffer(ComputeBuffer&& other) noexcept
{
  *this = std::move(other);
}

ComputeBuffer& ComputeBuffer::operator=(ComputeBuffer&& other) noexcept
{
  if (this != &other)
  {
    this->Free();
    this->Resources = other.Resources;
    this->Generation = std::exchange(other.Generation, 0);
    this->Name = std::exchange(other.Name, 0);
    this->Size = std::exchange(other.Size, 0);
    this->Capacity = std::exchange(other.Capacity, 0);
    this->SmallUses = std::exchange(other.SmallUses, 0);
    this->MaxSmallUse = std::exchange(other.MaxSmallUse, 0);
    this->Error = std::move(other.Error);
  }
  return *this;
}

bool ComputeBuffer::Fail(const std::string& what)
{
  this->Error = what;
  return false;
}

bool ComputeBuffer::IsLost() const
{
  return this->Name != 0 && this->Generation != this->Resources->Generation;
}

std::size_t ComputeBuffer::GetSize() const
{
  return this->IsLost() ? 0 : this->Size;
}

std::size_t ComputeBuffer::GetCapacity() const
{
  return this->IsLost() ? 0 : this->Capacity;
}

void ComputeBuffer::Free()
{
  if (this->Name != 0 && !this->IsLost())
  {
    // If the context cannot be entered now, it frees the name itself when it ends.
    std::optional<ContextScope> scope;
    if (Enter(*this->Resources, scope))
    {
      this->Resources->FreeBuffer(this->Name);
    }
  }
  this->Name = 0;
  this->Generation = 0;
  this->Size = 0;
  this->Capacity = 0;
  this->SmallUses = 0;
  this->MaxSmallUse = 0;
}

bool ComputeBuffer::Create(std::size_t bytes)
{
  this->Free();
  GLuint name = 0;
  GL::GenBuffers(1, &name);
  GL::BindBuffer(GL_COPY_WRITE_BUFFER, name);
  const auto size = static_cast<GLsizeiptr>(bytes);
  if (GL::BufferStorage)
  {
    // In the memory of the device: NVIDIA's driver keeps a store with a hint of changes (GL_DYNAMIC_COPY) in
    // that of the host, from where shaders read and write it at a hundredth of the speed.
    GL::BufferStorage(GL_COPY_WRITE_BUFFER, size, nullptr, GL_DYNAMIC_STORAGE_BIT);
  }
  else
  {
    GL::BufferData(GL_COPY_WRITE_BUFFER, size, nullptr, GL_STATIC_COPY);
  }
  const std::string error = GL::TakeError();
  if (!error.empty())
  {
    GL::DeleteBuffers(1, &name);
    return this->Fail(error + " for a buffer of " + std::to_string(bytes) + " bytes");
  }
  this->Name = name;
  this->Generation = this->Resources->Generation;
  this->Capacity = bytes;
  this->Resources->AddBuffer(name, bytes);
  return true;
}

/// Returns the size of the store for a use of `bytes`: the present one, a larger one, or a smaller one after
/// many small uses.
std::size_t ComputeBuffer::ChooseCapacity(std::size_t bytes)
{
  if (bytes > this->Capacity)
  {
    // A new store takes a GPU's driver a tenth of a millisecond, so that the next one is rarely needed.
    return this->Resources && !this->Resources->IsSoftware ? std::max(bytes, 2 * this->Capacity) : bytes;
  }
  if (this->Capacity <= SmallStore || bytes >= this->Capacity / 4)
  {
    this->SmallUses = 0;
    this->MaxSmallUse = 0;
    return this->Capacity;
  }
  this->MaxSmallUse = std::max(this->MaxSmallUse, bytes);
  return ++this->SmallUses < UsesBeforeShrinking ? this->Capacity : this->MaxSmallUse;
}

bool ComputeBuffer::Allocate(std::size_t bytes)
{
  this->Error.clear();
  if (this->IsLost())
  {
    this->Free();
  }
  const std::size_t capacity = this->ChooseCapacity(bytes);
  if (capacity == this->Capacity)
  {
    this->Size = bytes;
    return true;
  }
  std::optional<ContextScope> scope;
  if (!this->Resources || !Enter(*this->Resources, scope))
  {
    return this->Fail("the compute context is not ready");
  }
  if (bytes > static_cast<std::size_t>(std::numeric_limits<GLsizeiptr>::max()))
  {
    this->Free();
    return this->Fail(std::to_string(bytes) + " bytes are too many for a buffer");
  }
  if (!this->Create(capacity))
  {
    return false;
  }
  this->Size = bytes;
  return true;
}

template <typename Copy>
bool ComputeBuffer::Transfer(const char* what, std::size_t bytes, std::size_t offset, const Copy& copy)
{
  const auto describe = [&]() { return std::string(what) + " of " + std::to_string(bytes) + " bytes"; };
  const std::size_t size = this->GetSize();
  if (offset > size || bytes > size - offset)
  {
    return this->Fail(
      describe() + " at " + std::to_string(offset) + " is outside a buffer of " + std::to_string(size));
  }
  if (bytes == 0)
  {
    return true;
  }
  std::optional<ContextScope> scope;
  if (!Enter(*this->Resources, scope))
  {
    return this->Fail("the compute context is not ready");
  }
  copy(static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes));
  const std::string error = GL::TakeError();
  return error.empty() || this->Fail(error + " in " + describe());
}

void* ComputeBuffer::BeginStaging(std::size_t bytes)
{
  ContextResources& resources = *this->Resources;
  if (resources.IsSoftware || !ContextScope::IsInside(resources.Context))
  {
    return nullptr;
  }
  if (!resources.Stage)
  {
    resources.Stage = std::make_unique<TransferStage>();
  }
  return resources.Stage->BeginUpload(bytes);
}

bool ComputeBuffer::EndStaging()
{
  this->Resources->Stage->Upload(this->Name, 0);
  const std::string error = GL::TakeError();
  return error.empty() || this->Fail(error + " in an upload of " + std::to_string(this->Size) + " bytes");
}

bool ComputeBuffer::Upload(const void* data, std::size_t bytes, std::size_t offset)
{
  this->Error.clear();
  if (offset == 0 && bytes > this->GetSize() && !this->Allocate(bytes))
  {
    return false;
  }
  return this->Transfer("an upload", bytes, offset,
    [&](GLintptr at, GLsizeiptr size)
    {
      const auto* from = static_cast<const unsigned char*>(data);
      while (size > 0)
      {
        const std::size_t part = std::min(static_cast<std::size_t>(size), TransferStage::MaximumBytes);
        void* memory = this->BeginStaging(part);
        if (!memory)
        {
          break;
        }
        std::memcpy(memory, from, part);
        this->Resources->Stage->Upload(this->Name, static_cast<std::size_t>(at));
        from += part;
        at += static_cast<GLintptr>(part);
        size -= static_cast<GLsizeiptr>(part);
      }
      if (size > 0)
      {
        if (!this->Resources->IsSoftware)
        {
          // Not every driver waits for shaders that read the buffer (TransferStage).
          GL::Finish();
        }
        GL::BindBuffer(GL_COPY_WRITE_BUFFER, this->Name);
        GL::BufferSubData(GL_COPY_WRITE_BUFFER, at, size, from);
      }
    });
}

bool ComputeBuffer::Read(void* data, std::size_t bytes, std::size_t offset)
{
  this->Error.clear();
  return this->Transfer("a read", bytes, offset,
    [&](GLintptr at, GLsizeiptr size)
    {
      GL::BindBuffer(GL_COPY_READ_BUFFER, this->Name);
      GL::GetBufferSubData(GL_COPY_READ_BUFFER, at, size, data);
    });
}

bool ComputeBuffer::Clear()
{
  this->Error.clear();
  if (this->GetSize() == 0)
  {
    return true;
  }
  std::optional<ContextScope> scope;
  if (!Enter(*this->Resources, scope))
  {
    return this->Fail("the compute context is not ready");
  }
  GL::BindBuffer(GL_COPY_WRITE_BUFFER, this->Name);
  GL::ClearBufferData(GL_COPY_WRITE_BUFFER, GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, nullptr);
  const std::string error = GL::TakeError();
  return error.empty() || this->Fail(error + " in clearing " + std::to_string(this->Size) + " bytes");
}

bool ComputeBuffer::Bind(unsigned int binding, std::size_t offset, std::size_t bytes)
{
  this->Error.clear();
  if (!this->Resources || !ContextScope::IsInside(this->Resources->Context))
  {
    return this->Fail("a buffer can be bound inside a scope of its context only");
  }
  std::size_t size = this->GetSize();
  if (offset > size || bytes > size - offset)
  {
    return this->Fail("the range of " + std::to_string(bytes) + " bytes at " + std::to_string(offset) +
      " is outside a buffer of " + std::to_string(size));
  }
  if (bytes == 0)
  {
    bytes = size - offset;
  }
  if (bytes == 0)
  {
    if ((this->Name == 0 || this->IsLost() || this->Capacity < MinBytes) && !this->Create(MinBytes))
    {
      return false;
    }
    this->Size = size;
    offset = 0;
    bytes = MinBytes;
  }
  const std::int64_t limit = this->Resources->MaximumStorageBlockSize;
  if (static_cast<std::uint64_t>(bytes) > static_cast<std::uint64_t>(limit))
  {
    return this->Fail(std::to_string(bytes) + " bytes are more than a shader storage block may have (" +
      std::to_string(limit) + "); bind parts");
  }
  if (offset % static_cast<std::size_t>(this->Resources->StorageOffsetAlignment) != 0)
  {
    return this->Fail("offset " + std::to_string(offset) + " is not a multiple of " +
      std::to_string(this->Resources->StorageOffsetAlignment));
  }
  // An error, as of a binding point that is not there, is found by the dispatch.
  GL::BindBufferRange(GL_SHADER_STORAGE_BUFFER, binding, this->Name, static_cast<GLintptr>(offset),
    static_cast<GLsizeiptr>(bytes));
  return true;
}

long ComputeBuffer::GetLiveCount()
{
  return ContextResources::GetLiveBuffers();
}

std::int64_t ComputeBuffer::GetLiveBytes()
{
  return ContextResources::GetLiveBytes();
}
}
