// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCascadedShadowMapPass
 * @brief   cascaded shadow maps: several layers a light, each for a range of depths
 *
 * D. B. Lloyd, D. Tuft, S. Yoon, D. Manocha, Warping and Partitioning for Low Error Shadow Maps,
 * 2006; F. Zhang, H. Sun, L. Xu, L. K. Lun, Parallel-Split Shadow Maps for Large-Scale Virtual
 * Environments, 2006. Resolution is that of each layer. By itself no layer is warped; SetWarp()
 * gives all of them a warp, by which each adapts to its own part of the view.
 *
 * @sa vtkAdaptiveShadowMapPass vtkDepthSplitShadowMapPartition
 */
#ifndef vtkCascadedShadowMapPass_h
#define vtkCascadedShadowMapPass_h

#include "vtkAdaptiveShadowMapPass.h"

class vtkDepthSplitShadowMapPartition;

class VTKRTWSHADOWS_EXPORT vtkCascadedShadowMapPass : public vtkAdaptiveShadowMapPass
{
public:
  static vtkCascadedShadowMapPass* New();
  vtkTypeMacro(vtkCascadedShadowMapPass, vtkAdaptiveShadowMapPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * As vtkDepthSplitShadowMapPartition::SplitSchemes.
   */
  enum SplitSchemes
  {
    UNIFORM = 0,
    LOGARITHMIC = 1,
    PRACTICAL = 2,
    SAMPLE_DISTRIBUTION = 3
  };

  ///@{
  /**
   * The settings of the pass's partition, for short: see vtkDepthSplitShadowMapPartition for units,
   * ranges and defaults. They stay with that partition when another is set.
   */
  void SetNumberOfLayers(int layers);
  int GetNumberOfLayers();
  void SetSplitScheme(int scheme);
  void SetSplitSchemeToUniform() { this->SetSplitScheme(UNIFORM); }
  void SetSplitSchemeToLogarithmic() { this->SetSplitScheme(LOGARITHMIC); }
  void SetSplitSchemeToPractical() { this->SetSplitScheme(PRACTICAL); }
  void SetSplitSchemeToSampleDistribution() { this->SetSplitScheme(SAMPLE_DISTRIBUTION); }
  int GetSplitScheme();
  void SetLambda(double lambda);
  double GetLambda();
  void SetBlendWidth(double share);
  double GetBlendWidth();
  void SetStable(bool stable);
  bool GetStable();
  void StableOn() { this->SetStable(true); }
  void StableOff() { this->SetStable(false); }
  void SetSplitFaces(bool split);
  bool GetSplitFaces();
  void SplitFacesOn() { this->SetSplitFaces(true); }
  void SplitFacesOff() { this->SetSplitFaces(false); }
  ///@}

  /**
   * The partition that the pass begins with, whose settings are those of the technique. It stays
   * what it is when another is set.
   */
  vtkDepthSplitShadowMapPartition* GetDepthSplits();

protected:
  vtkCascadedShadowMapPass();
  ~vtkCascadedShadowMapPass() override;

private:
  vtkCascadedShadowMapPass(const vtkCascadedShadowMapPass&) = delete;
  void operator=(const vtkCascadedShadowMapPass&) = delete;

  vtkNew<vtkDepthSplitShadowMapPartition> DepthSplits;
};

#endif
