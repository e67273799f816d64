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
   * Where the depths that are seen are split, as vtkDepthSplitShadowMapPartition::SplitSchemes.
   */
  enum SplitSchemes
  {
    UNIFORM = 0,            ///< in even steps
    LOGARITHMIC = 1,        ///< in even ratios (Lloyd et al. 2006, equations 15 and 16)
    PRACTICAL = 2,          ///< between UNIFORM and LOGARITHMIC, by Lambda (Zhang et al. 2006)
    SAMPLE_DISTRIBUTION = 3 ///< where the view samples predict the least error
  };

  ///@{
  /**
   * Layers of each light by depth; with SplitFaces each light has four times as many. Clamped
   * to 1 to 8. Default: 4. Like all settings below, it is one of the partition that the pass
   * begins with, and stays with that partition when another is set.
   */
  void SetNumberOfLayers(int layers);
  int GetNumberOfLayers();
  ///@}

  ///@{
  /**
   * How the depths are split: one of SplitSchemes; any other value is refused with an error.
   * Default: SAMPLE_DISTRIBUTION.
   */
  void SetSplitScheme(int scheme);
  void SetSplitSchemeToUniform() { this->SetSplitScheme(UNIFORM); }
  void SetSplitSchemeToLogarithmic() { this->SetSplitScheme(LOGARITHMIC); }
  void SetSplitSchemeToPractical() { this->SetSplitScheme(PRACTICAL); }
  void SetSplitSchemeToSampleDistribution() { this->SetSplitScheme(SAMPLE_DISTRIBUTION); }
  int GetSplitScheme();
  ///@}

  ///@{
  /**
   * The weight of logarithmic splits in PRACTICAL, uniform ones having the rest (Zhang et al.
   * 2006). Clamped to 0 (uniform) to 1 (logarithmic). A value that is not a number is refused
   * with an error. Default: 0.5.
   */
  void SetLambda(double lambda);
  double GetLambda();
  ///@}

  ///@{
  /**
   * Width of the band of depths in which the shadows of a layer and of the next one are mixed,
   * as a share of the depths of the layer. Clamped to 0 (a seam) to 1. A value that is not a
   * number is refused with an error. Default: 0.
   */
  void SetBlendWidth(double share);
  double GetBlendWidth();
  ///@}

  ///@{
  /**
   * Whether the texels of layers without a warp lie still in the world while the camera moves,
   * so that shadow edges do not crawl: see vtkDepthSplitShadowMapPartition::SetStable() for
   * what that costs. Default: off.
   */
  void SetStable(bool stable);
  bool GetStable();
  void StableOn() { this->SetStable(true); }
  void StableOff() { this->SetStable(false); }
  ///@}

  ///@{
  /**
   * Whether each range of depths is divided among the four sides of the view frustum too, a
   * layer for each (Lloyd et al. 2006, section 5.1). Default: off.
   */
  void SetSplitFaces(bool split);
  bool GetSplitFaces();
  void SplitFacesOn() { this->SetSplitFaces(true); }
  void SplitFacesOff() { this->SetSplitFaces(false); }
  ///@}

  /**
   * The partition that the pass begins with, which holds the settings above. It stays the same
   * object when another partition is set.
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
