#include "rtwStageTimers.h"

#include "rtwOpenGL.h"

#include <algorithm>

namespace rtw
{
StageTimers::Scope::Scope(StageTimers& timers, const char* stage)
  : Timers(timers.Enabled ? &timers : nullptr)
{
  if (this->Timers)
  {
    this->Timers->Begin(stage);
  }
}

StageTimers::Scope::~Scope()
{
  if (this->Timers)
  {
    this->Timers->End();
  }
}

void StageTimers::Begin(const char* stage)
{
  if (this->Free.empty())
  {
    GLuint id = 0;
    glGenQueries(1, &id);
    this->Free.push_back(id);
  }
  this->Frames[this->Current].push_back({ stage, this->Free.back() });
  this->Free.pop_back();
  glBeginQuery(GL_TIME_ELAPSED, this->Frames[this->Current].back().Id);
}

void StageTimers::End()
{
  glEndQuery(GL_TIME_ELAPSED);
}

void StageTimers::NextFrame()
{
  this->Current = (this->Current + 1) % FramesKept;
  this->Collect(this->Frames[this->Current]);
}

void StageTimers::Collect(std::vector<Query>& queries)
{
  if (queries.empty())
  {
    return;
  }
  GLint ready = 0;
  glGetQueryObjectiv(queries.back().Id, GL_QUERY_RESULT_AVAILABLE, &ready);
  if (ready)
  {
    this->Results.clear();
  }
  for (const Query& query : queries)
  {
    if (ready)
    {
      GLuint64 nanoseconds = 0;
      glGetQueryObjectui64v(query.Id, GL_QUERY_RESULT, &nanoseconds);
      const auto same = [&](const Result& result) { return result.Name == query.Stage; };
      auto at = std::find_if(this->Results.begin(), this->Results.end(), same);
      if (at == this->Results.end())
      {
        at = this->Results.insert(at, { query.Stage, 0.0 });
      }
      at->Milliseconds += 1e-6 * static_cast<double>(nanoseconds);
    }
    this->Free.push_back(query.Id);
  }
  queries.clear();
}

void StageTimers::Release()
{
  for (auto& frame : this->Frames)
  {
    for (const Query& query : frame)
    {
      this->Free.push_back(query.Id);
    }
    frame.clear();
  }
  if (!this->Free.empty())
  {
    glDeleteQueries(static_cast<GLsizei>(this->Free.size()), this->Free.data());
  }
  this->Abandon();
}

void StageTimers::Abandon()
{
  for (auto& frame : this->Frames)
  {
    frame.clear();
  }
  this->Free.clear();
  this->Results.clear();
}
}
