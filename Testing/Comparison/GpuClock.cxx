// SPDX-License-Identifier: BSD-3-Clause
#include "rtwGpuClock.h"

#include "GL/rtwOpenGL.h"

namespace rtw
{
GpuClock::GpuClock()
{
  if (glQueryCounter)
  {
    glGenQueries(2, this->Queries);
    glQueryCounter(this->Queries[0], GL_TIMESTAMP);
    glFlush(); // Mesa's llvmpipe stamps when what is in the same batch has been drawn
  }
}

GpuClock::~GpuClock()
{
  if (this->Queries[0])
  {
    glDeleteQueries(2, this->Queries);
  }
}

void GpuClock::Stop()
{
  if (this->Queries[1])
  {
    glQueryCounter(this->Queries[1], GL_TIMESTAMP);
  }
}

double GpuClock::GetMilliseconds() const
{
  if (!this->Queries[0])
  {
    return 0;
  }
  GLuint64 begin = 0, end = 0;
  glGetQueryObjectui64v(this->Queries[0], GL_QUERY_RESULT, &begin);
  glGetQueryObjectui64v(this->Queries[1], GL_QUERY_RESULT, &end);
  return end > begin ? 1e-6 * double(end - begin) : 0;
}
}
