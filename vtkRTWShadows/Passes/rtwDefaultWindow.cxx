// SPDX-License-Identifier: BSD-3-Clause
// vtkRTWEGLRenderWindow as the class that vtkRenderWindow::New() gives.
#include "vtkRTWEGLRenderWindow.h"

#include "vtkGenericRenderWindowInteractor.h"
#include "vtkObjectFactory.h"
#include "vtkObjectFactoryCollection.h"
#include "vtkVersion.h"

#include <cstdlib>
#include <string>
#include <vector>

#ifndef VTK_FUTURE_CONST
#define VTK_FUTURE_CONST // VTK < 9.4
#endif

VTK_CREATE_CREATE_FUNCTION(vtkRTWEGLRenderWindow);
VTK_CREATE_CREATE_FUNCTION(vtkGenericRenderWindowInteractor);

namespace
{
class rtwDefaultWindowFactory : public vtkObjectFactory
{
public:
  static rtwDefaultWindowFactory* New();
  vtkTypeMacro(rtwDefaultWindowFactory, vtkObjectFactory);
  const char* GetVTKSourceVersion() VTK_FUTURE_CONST override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() VTK_FUTURE_CONST override { return "headless EGL windows"; }

protected:
  rtwDefaultWindowFactory()
  {
    this->RegisterOverride("vtkRenderWindow", "vtkRTWEGLRenderWindow", "headless EGL window", 1,
      vtkObjectFactoryCreatevtkRTWEGLRenderWindow);
    this->RegisterOverride("vtkRenderWindowInteractor", "vtkGenericRenderWindowInteractor",
      "interactor with no event loop", 1, vtkObjectFactoryCreatevtkGenericRenderWindowInteractor);
  }
};
vtkStandardNewMacro(rtwDefaultWindowFactory);

// An override of somebody else's that was switched off to make room for ours.
struct DisabledOverride
{
  vtkObjectFactory* Factory;
  std::string Class;
  std::string Subclass;
};

// Plain pointers, since VTK owns the factories and may have dropped any of them since: each is
// looked up among the registered ones before it is used.
vtkObjectFactory* InstalledFactory = nullptr;

std::vector<DisabledOverride>& GetDisabledOverrides()
{
  static std::vector<DisabledOverride> overrides;
  return overrides;
}

bool IsRegistered(vtkObjectFactory* factory)
{
  return factory && vtkObjectFactory::GetRegisteredFactories()->IsItemPresent(factory) != 0;
}

bool HasDisplay()
{
#if defined(_WIN32) || defined(__APPLE__)
  return true; // their native windows draw off screen without one
#else
  for (const char* name : { "DISPLAY", "WAYLAND_DISPLAY" })
  {
    const char* value = std::getenv(name);
    if (value && *value)
    {
      return true;
    }
  }
  return false;
#endif
}

// VTK takes the first factory that has an enabled override, so those before ours must be off.
void DisableOverridesOf(const std::string& name)
{
  vtkCollectionSimpleIterator it;
  vtkObjectFactoryCollection* factories = vtkObjectFactory::GetRegisteredFactories();
  factories->InitTraversal(it);
  while (vtkObjectFactory* factory = factories->GetNextObjectFactory(it))
  {
    for (int i = 0; i < factory->GetNumberOfOverrides(); ++i)
    {
      if (name == factory->GetClassOverrideName(i) && factory->GetEnableFlag(i))
      {
        const std::string subclass = factory->GetClassOverrideWithName(i);
        factory->SetEnableFlag(0, name.c_str(), subclass.c_str());
        GetDisabledOverrides().push_back({ factory, name, subclass });
      }
    }
  }
}
}

bool vtkRTWEGLRenderWindow::InstallAsDefault(bool onlyWithoutDisplay)
{
  if (IsRegistered(InstalledFactory))
  {
    return true;
  }
  if (!RTW_HAVE_EGL || (onlyWithoutDisplay && HasDisplay()))
  {
    return false;
  }
  DisableOverridesOf("vtkRenderWindow");
  DisableOverridesOf("vtkRenderWindowInteractor");
  InstalledFactory = rtwDefaultWindowFactory::New();
  vtkObjectFactory::RegisterFactory(InstalledFactory);
  InstalledFactory->Delete(); // VTK holds it
  return true;
}

void vtkRTWEGLRenderWindow::UninstallAsDefault()
{
  if (!IsRegistered(InstalledFactory))
  {
    return;
  }
  vtkObjectFactory::UnRegisterFactory(InstalledFactory);
  InstalledFactory = nullptr;
  for (const DisabledOverride& was : GetDisabledOverrides())
  {
    if (IsRegistered(was.Factory))
    {
      was.Factory->SetEnableFlag(1, was.Class.c_str(), was.Subclass.c_str());
    }
  }
  GetDisabledOverrides().clear();
}
