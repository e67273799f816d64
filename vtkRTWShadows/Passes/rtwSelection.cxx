// SPDX-License-Identifier: BSD-3-Clause
#include "Passes/rtwSelection.h"

#include "GL/rtwOpenGL.h"
#include "Passes/rtwDetachment.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderPass.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

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
  // A selector's colours are numbers.
  const Detachment detachment({ s->GetPropArray(), s->GetPropArray() + s->GetPropArrayCount() });
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
