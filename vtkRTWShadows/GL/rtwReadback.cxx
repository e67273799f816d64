// SPDX-License-Identifier: BSD-3-Clause
#include "GL/rtwReadback.h"

#include "GL/rtwBuffer.h"
#include "GL/rtwOpenGL.h"
#include "GL/rtwStateRecord.h"

#include <cstring>

namespace rtw
{
namespace
{
GLenum Wait(void* fence, GLuint64 nanoseconds)
{
  return glClientWaitSync(static_cast<GLsync>(fence), GL_SYNC_FLUSH_COMMANDS_BIT, nanoseconds);
}
}

// The handles of a readback that nobody released went with their context.
Readback::~Readback() = default;

void Readback::Start(const Buffer& from, std::size_t bytes)
{
  this->DropFence();
  const bool fits = this->Id && this->Bytes == bytes;
  if (!this->Id)
  {
    glGenBuffers(1, &this->Id);
  }
  this->Bytes = bytes;
  const BriefChange change;
  from.Bind(GL_COPY_READ_BUFFER);
  BindBuffer(GL_COPY_WRITE_BUFFER, this->Id);
  if (!fits)
  {
    glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, GL_STREAM_READ);
  }
  glCopyBufferSubData(
    GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, static_cast<GLsizeiptr>(bytes));
  this->Fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

bool Readback::IsReady() const
{
  const GLenum state = this->Fence ? Wait(this->Fence, 0) : GL_TIMEOUT_EXPIRED;
  return state != GL_TIMEOUT_EXPIRED;
}

bool Readback::Read(void* data)
{
  constexpr GLuint64 second = 1000000000;
  GLenum state = this->Fence ? GL_TIMEOUT_EXPIRED : GL_WAIT_FAILED;
  while (state == GL_TIMEOUT_EXPIRED)
  {
    state = Wait(this->Fence, second);
  }
  this->DropFence();
  if (state == GL_WAIT_FAILED)
  {
    return false;
  }
  const BriefChange change;
  BindBuffer(GL_COPY_READ_BUFFER, this->Id);
  const void* values =
    glMapBufferRange(GL_COPY_READ_BUFFER, 0, static_cast<GLsizeiptr>(this->Bytes), GL_MAP_READ_BIT);
  bool whole = false;
  if (values)
  {
    std::memcpy(data, values, this->Bytes);
    whole = glUnmapBuffer(GL_COPY_READ_BUFFER) == GL_TRUE;
  }
  return whole;
}

void Readback::DropFence()
{
  if (this->Fence)
  {
    glDeleteSync(static_cast<GLsync>(this->Fence));
    this->Fence = nullptr;
  }
}

void Readback::Release()
{
  this->DropFence();
  if (this->Id)
  {
    glDeleteBuffers(1, &this->Id);
  }
  this->Abandon();
}

void Readback::Abandon()
{
  this->Id = 0;
  this->Bytes = 0;
  this->Fence = nullptr;
}
}
