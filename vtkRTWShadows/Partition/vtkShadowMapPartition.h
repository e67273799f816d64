// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowMapPartition
 * @brief   into how many layers what a light shines on is divided
 *
 * One of the independent axes of a vtkAdaptiveShadowMapPass. This class is the simplest: one layer
 * a light, which holds all that the camera sees. One object may serve several passes.
 *
 * @sa vtkAdaptiveShadowMapPass vtkDepthSplitShadowMapPartition
 */
#ifndef vtkShadowMapPartition_h
#define vtkShadowMapPartition_h

#include "vtkObject.h"
#include "vtkRTWShadowsModule.h" // for the export macro

#include <memory> // for the stage

namespace rtw
{
class PartitionStage;
}

class VTKRTWSHADOWS_EXPORT vtkShadowMapPartition : public vtkObject
{
public:
  static vtkShadowMapPartition* New();
  vtkTypeMacro(vtkShadowMapPartition, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Layers a light. Always 1 here.
   */
  virtual int GetNumberOfLayers() { return 1; }

#ifndef __VTK_WRAP__
  /**
   * The GPU side of this partition, for one pass. It asks this object for its settings, which has
   * to stay as long as it is in use.
   */
  virtual std::unique_ptr<rtw::PartitionStage> MakeStage();
#endif

protected:
  vtkShadowMapPartition();
  ~vtkShadowMapPartition() override;

private:
  vtkShadowMapPartition(const vtkShadowMapPartition&) = delete;
  void operator=(const vtkShadowMapPartition&) = delete;
};

#endif
