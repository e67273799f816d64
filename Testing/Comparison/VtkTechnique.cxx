// SPDX-License-Identifier: BSD-3-Clause
#include "rtwPictures.h"
#include "rtwReference.h"
#include "rtwTechnique.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCameraPass.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkLookupTable.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderWindow.h>
#include <vtkSequencePass.h>
#include <vtkShadowMapBakerPass.h>
#include <vtkShadowMapPass.h>

namespace rtw
{
namespace
{
// VTK 9.1's sticks need scalars: they get white ones.
void DropColours(vtkMapper* mapper)
{
  if (!mapper->IsA("vtkOpenGLStickMapper"))
  {
    mapper->ScalarVisibilityOff();
    return;
  }
  vtkNew<vtkLookupTable> white;
  white->SetNumberOfTableValues(1);
  white->SetTableValue(0, 1, 1, 1);
  mapper->SetColorModeToMapScalars();
  mapper->SetLookupTable(white);
}

// White where there is the first light, by its angle alone, so that brightness tells the shadow.
void MakePlain(vtkRenderer* renderer)
{
  vtkActorCollection* actors = renderer->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor())
  {
    vtkProperty* property = actor->GetProperty();
    property->SetColor(1, 1, 1);
    property->SetAmbient(0);
    property->SetDiffuse(1);
    property->SetSpecular(0);
    if (actor->GetMapper())
    {
      DropColours(actor->GetMapper());
    }
  }
  vtkLightCollection* lights = renderer->GetLights();
  for (int i = 0; i < lights->GetNumberOfItems(); ++i)
  {
    auto* light = vtkLight::SafeDownCast(lights->GetItemAsObject(i));
    light->SetIntensity(i == 0);
    light->SetSwitch(i == 0);
  }
  renderer->SetBackground(0, 0, 0);
}

class VtkTechnique : public Technique
{
public:
  explicit VtkTechnique(int resolution)
    : Resolution(resolution)
  {
    this->Shadows->GetShadowMapBakerPass()->SetResolution(resolution);
    vtkNew<vtkRenderPassCollection> passes;
    passes->AddItem(this->Shadows->GetShadowMapBakerPass());
    passes->AddItem(this->Shadows);
    vtkNew<vtkSequencePass> sequence;
    sequence->SetPasses(passes);
    this->Chain->SetDelegatePass(sequence);
  }

  void Install(vtkRenderer* renderer) override
  {
    this->Renderer = renderer;
    renderer->SetPass(this->Chain);
  }

  void SetRebuilding(bool rebuilding) override { this->IsRebuilding = rebuilding; }

  void PrepareFrame() override
  {
    if (this->IsRebuilding)
    {
      vtkLight::SafeDownCast(this->Renderer->GetLights()->GetItemAsObject(0))->Modified();
    }
  }

  bool GoesOnAfterMask() const override { return false; }

  // The pass gives no mask: a pixel is lit if shadows leave at least half of its light.
  std::vector<unsigned char> MakeMask() override
  {
    MakePlain(this->Renderer);
    const auto without = this->Draw(nullptr);
    this->PrepareFrame();
    const auto with = this->Draw(this->Chain);
    std::vector<unsigned char> mask(size_t(with->GetNumberOfPoints()));
    const auto* lit = static_cast<const unsigned char*>(with->GetScalarPointer());
    const auto* full = static_cast<const unsigned char*>(without->GetScalarPointer());
    for (size_t i = 0; i < mask.size(); ++i)
    {
      mask[i] = full[3 * i] == 0        ? MASK_AVERTED
        : 2 * lit[3 * i] >= full[3 * i] ? MASK_LIT
                                        : MASK_SHADOW;
    }
    return mask;
  }

  // A map of one float, and the depth buffer that it is drawn with.
  int64_t GetMemory() override { return int64_t(8) * this->Resolution * this->Resolution; }

  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Chain->ReleaseGraphicsResources(window);
    this->Shadows->ReleaseGraphicsResources(window);
  }

private:
  vtkSmartPointer<vtkImageData> Draw(vtkRenderPass* pass)
  {
    this->Renderer->SetPass(pass);
    this->Renderer->GetRenderWindow()->Render();
    return Grab(this->Renderer->GetRenderWindow());
  }

  int Resolution;
  bool IsRebuilding = true;
  vtkNew<vtkShadowMapPass> Shadows;
  vtkNew<vtkCameraPass> Chain;
  vtkRenderer* Renderer = nullptr;
};
}

std::unique_ptr<Technique> MakeVtkTechnique(const TechniqueSettings& settings)
{
  return std::make_unique<VtkTechnique>(settings.Resolution);
}
}
