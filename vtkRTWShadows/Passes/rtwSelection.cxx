// SPDX-License-Identifier: BSD-3-Clause
#include "rtwSelection.h"

#include "rtwOpenGL.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkSmartPointer.h"

#include <utility>
#include <vector>

namespace rtw
{
namespace
{
// A pass is what VTK lets at the steps of a renderer.
class RendererSteps : public vtkRenderPass
{
public:
  static RendererSteps* New();
  vtkTypeMacro(RendererSteps, vtkRenderPass);

  void Render(const vtkRenderState* s) override
  {
    this->UpdateCamera(s->GetRenderer());
    this->UpdateLightGeometry(s->GetRenderer());
    this->UpdateLights(s->GetRenderer());
    // Which leaves the props to the selector.
    this->UpdateGeometry(s->GetRenderer());
  }
};
vtkStandardNewMacro(RendererSteps);

// While one lives, no pass has code in the shaders of a state's props: a selector's colours are numbers.
class Detachment
{
public:
  explicit Detachment(const vtkRenderState* s)
  {
    for (int i = 0; i < s->GetPropArrayCount(); ++i)
    {
      vtkInformation* keys = s->GetPropArray()[i]->GetPropertyKeys();
      const int passes = keys ? keys->Length(vtkOpenGLRenderPass::RenderPasses()) : 0;
      for (int k = 0; k < passes; ++k)
      {
        this->Attached.emplace_back(keys, keys->Get(vtkOpenGLRenderPass::RenderPasses(), k));
      }
      if (passes > 0)
      {
        keys->Remove(vtkOpenGLRenderPass::RenderPasses());
      }
    }
  }

  ~Detachment()
  {
    for (const auto& [keys, pass] : this->Attached)
    {
      keys->Append(vtkOpenGLRenderPass::RenderPasses(), pass);
    }
  }

  Detachment(const Detachment&) = delete;
  Detachment& operator=(const Detachment&) = delete;

private:
  std::vector<std::pair<vtkSmartPointer<vtkInformation>, vtkSmartPointer<vtkObjectBase>>> Attached;
};
}

bool RenderSelection(const vtkRenderState* s)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(s->GetRenderer()->GetRenderWindow());
  if (!s->GetRenderer()->GetSelector() || !window)
  {
    return false;
  }
  window->MakeCurrent();
  vtkOpenGLState* state = window->GetState();
  const Detachment detachment(s);
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  // The selector reads the window, which a pass around this one may have turned away from.
  state->PushFramebufferBindings();
  window->GetRenderFramebuffer()->Bind();
  vtkNew<RendererSteps> steps;
  steps->Render(s);
  state->PopFramebufferBindings();
  return true;
}

bool IsSelecting(vtkRenderer* renderer)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  vtkRendererCollection* all = window ? window->GetRenderers() : nullptr;
  for (int i = 0; all && i < all->GetNumberOfItems(); ++i)
  {
    auto* other = vtkRenderer::SafeDownCast(all->GetItemAsObject(i));
    if (other && other->GetSelector())
    {
      return true;
    }
  }
  return renderer->GetSelector() != nullptr;
}
}
