// SPDX-License-Identifier: BSD-3-Clause
#include "rtwConditional.h"

#include "rtwOpenGL.h"

namespace rtw
{
void Conditional::Decide(const std::function<void()>& draw)
{
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
