// SPDX-License-Identifier: BSD-3-Clause
#include "GL/rtwConditional.h"

#include "GL/rtwOpenGL.h"

namespace rtw
{
namespace
{
bool IsCounting()
{
  for (const GLenum target :
    { GL_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED_CONSERVATIVE })
  {
    GLint query = 0;
    glGetQueryiv(target, GL_CURRENT_QUERY, &query);
    if (query != 0)
    {
      return true;
    }
  }
  return false;
}
}

void Conditional::Decide(const std::function<void()>& draw)
{
  this->Decided = !IsCounting();
  if (!this->Decided)
  {
    return;
  }
  if (!this->Id)
  {
    glGenQueries(1, &this->Id);
  }
  glBeginQuery(GL_ANY_SAMPLES_PASSED, this->Id);
  draw();
  glEndQuery(GL_ANY_SAMPLES_PASSED);
}

void Conditional::Draw(const std::function<void()>& draw) const
{
  if (!this->Decided)
  {
    return;
  }
  glBeginConditionalRender(this->Id, GL_QUERY_WAIT);
  draw();
  glEndConditionalRender();
}

void Conditional::Release()
{
  if (this->Id)
  {
    glDeleteQueries(1, &this->Id);
  }
  this->Abandon();
}
}
