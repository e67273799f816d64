// SPDX-License-Identifier: BSD-3-Clause
#include "Passes/rtwReceiverCode.h"

#include "vtkObjectFactory.h"
#include "vtkWeakPointer.h"

#include <iterator>
#include <map>
#include <mutex>

namespace rtw
{
namespace
{
// Windows may be drawn by several threads, each of which draws one at a time.
thread_local vtkOpenGLRenderPass* Answers = nullptr;
}

vtkStandardNewMacro(ReceiverCodePass);

ReceiverCode ReceiverCode::Make(const ReceiverShape& shape, Receiving way, bool drawsItself)
{
  ReceiverCode code;
  if (way == Receiving::Direct)
  {
    code.Shape = shape;
  }
  else
  {
    // A mask holds decisions, however they were come to.
    code.Shape.Switched = shape.Switched;
    code.Shape.Warp = drawsItself ? shape.Warp : WarpShape{};
  }
  code.Way = way;
  code.DrawsItself = drawsItself;
  return code;
}

std::string ReceiverCode::GetName() const
{
  std::string name = DefinitionsOf(this->Shape);
  name += this->Shape.Warp.Name ? this->Shape.Warp.Name : "";
  for (const int light : this->Shape.Switched)
  {
    name += ' ' + std::to_string(light);
  }
  return name + '/' + std::to_string(static_cast<int>(this->Way)) + (this->DrawsItself ? "+" : "");
}

vtkSmartPointer<ReceiverCodePass> ReceiverCodePass::Of(const std::string& name)
{
  static std::mutex mutex;
  static std::map<std::string, vtkWeakPointer<ReceiverCodePass>> known;
  const std::lock_guard<std::mutex> lock(mutex);
  vtkSmartPointer<ReceiverCodePass> pass = known[name].Get();
  if (!pass)
  {
    for (auto at = known.begin(); at != known.end();)
    {
      at = at->second ? std::next(at) : known.erase(at);
    }
    pass = vtkSmartPointer<ReceiverCodePass>::New();
    known[name] = pass;
  }
  return pass;
}

ReceiverCodePass::Answering::Answering(vtkOpenGLRenderPass* pass)
  : Before(Answers)
{
  Answers = pass;
}

ReceiverCodePass::Answering::~Answering()
{
  Answers = this->Before;
}

bool ReceiverCodePass::PreReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper,
  vtkProp* prop)
{
  return !Answers ||
    Answers->PreReplaceShaderValues(vertexShader, geometryShader, fragmentShader, mapper, prop);
}

bool ReceiverCodePass::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper,
  vtkProp* prop)
{
  return !Answers ||
    Answers->PostReplaceShaderValues(vertexShader, geometryShader, fragmentShader, mapper, prop);
}

bool ReceiverCodePass::SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper,
  vtkProp* prop, vtkOpenGLVertexArrayObject* VAO)
{
  return !Answers || Answers->SetShaderParameters(program, mapper, prop, VAO);
}

vtkMTimeType ReceiverCodePass::GetShaderStageMTime()
{
  return Answers ? Answers->GetShaderStageMTime() : 0;
}
}
