// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInspectableShadowMapPass
 * @brief   looking inside shadow maps: debug views, and what they show as numbers
 *
 * What all vtkAdaptiveShadowMapPass have for those who want to see why a shadow is as fine or as
 * coarse as it is.
 *
 * @sa vtkAdaptiveShadowMapPass
 */
#ifndef vtkInspectableShadowMapPass_h
#define vtkInspectableShadowMapPass_h

#include "vtkRTWShadowsModule.h" // for the export macro
#include "vtkShadowMapPass.h"
#include "vtkWeakPointer.h" // for the light that is looked at

class vtkImageData;
class vtkLight;

class VTKRTWSHADOWS_EXPORT vtkInspectableShadowMapPass : public vtkShadowMapPass
{
public:
  vtkAbstractTypeMacro(vtkInspectableShadowMapPass, vtkShadowMapPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What opaque receivers show instead of their own colours. Where they are turned away from the
   * light, or out of its reach, they are grey (0.5); only WARP_GRID leaves them as they are.
   */
  enum DebugViews
  {
    NONE = 0, ///< the picture
    /// How much of the light comes through: from dark blue, none, to light yellow, all.
    SHADOW = 1,
    /// How wide a texel is on the surface beside a pixel, along that of the map's axes where it is
    /// wider (Lloyd et al. 2006, equation 1). White is 1; every octave on, 2, 4, 8 and 16 times too
    /// wide, is yellow, orange, red and dark red, where shadow edges show their texels; 2, 4, 8 and
    /// 16 times as fine as pixels is light blue, blue, royal blue and dark blue.
    ALIASING_ERROR = 2,
    /// How dense texels are where the pixel falls, as importance spread them: a length's, in times
    /// the mean over the map (an area's is the square of that). Every octave from 1/16 on is black,
    /// indigo, purple, plum, red (the mean), orange, amber, yellow and cream (16).
    IMPORTANCE = 3,
    /// The lit picture, and on it lines at each 64th part of the map, across s orange, across t
    /// blue, and wider ones at each eighth; none where they are too dense to tell.
    WARP_GRID = 4,
    /// A colour for each layer that is looked up, by its number, light by light: blue, orange,
    /// green, pink, violet, olive, and again. Two, of the light's own casters and of those that
    /// only VTK's mappers draw, share the surface in stripes. Grey beyond the focus.
    LAYERS = 5,
    /// How many view samples the texel holds on which the pixel falls, of a vtkExactShadowMapPass:
    /// 1 is black, and every octave on indigo, purple, plum, red (16), orange, amber, yellow and
    /// cream (256). Others warn once, when it is first drawn, and show the picture.
    LIST_LENGTHS = 6
  };

  ///@{
  /**
   * One of DebugViews; any other value is refused with an error. It is painted over what the opaque
   * pass has drawn, so that no shader of a mapper changes, translucent props and what receives no
   * shadow look as usual, and NONE costs nothing. The maps are the same whatever is viewed. In
   * windows with several samples a pixel all that a pixel shows of receivers has the colour of its
   * centre. Default: NONE.
   */
  virtual void SetDebugView(int view);
  vtkGetMacro(DebugView, int);
  void SetDebugViewToNone() { this->SetDebugView(NONE); }
  void SetDebugViewToShadow() { this->SetDebugView(SHADOW); }
  void SetDebugViewToAliasingError() { this->SetDebugView(ALIASING_ERROR); }
  void SetDebugViewToImportance() { this->SetDebugView(IMPORTANCE); }
  void SetDebugViewToWarpGrid() { this->SetDebugView(WARP_GRID); }
  void SetDebugViewToLayers() { this->SetDebugView(LAYERS); }
  void SetDebugViewToListLengths() { this->SetDebugView(LIST_LENGTHS); }
  ///@}

  ///@{
  /**
   * The light that DebugView shows, by its number among those with shadows. What is negative is
   * refused with an error; where there are fewer lights it is the last one's, with a warning, when
   * it is first drawn. Default: 0.
   *
   * A vtkLight is looked up in each frame, so that it stays the one that is viewed whatever other
   * lights come and go, and GetDebugLight() gives the number that it had when it was last viewed.
   * It isn't kept alive. Where it casts no shadow that number's light is viewed, with a warning,
   * once. Null is refused with an error.
   */
  virtual void SetDebugLight(int light);
  virtual void SetDebugLight(vtkLight* light);
  vtkGetMacro(DebugLight, int);
  ///@}

  /**
   * What a light's warping maps were made from (Rosen 2012, section 4.2): row 0 along s, row 1
   * along t, a pixel a cell, of two floats: the importance as it was collected, before the blur,
   * and as it was used, blurred and raised to the floor, which is what the density of texels is
   * proportional to. Importance is in the unit of its functions: the greatest of a cell's samples,
   * with SAMPLE_COUNT their sum, and with SQRT_DEMAND the square root of the sum of one over the
   * footprint, which is a share of the focus. Sums are over view samples, of which there is one in
   * ViewSampleStride pixels along both axes; those of a FORWARD analysis are over all pixels. Of a
   * vtkNonOrthogonalShadowMapWarp two slices of such rows, one for each of its functions. Null
   * also where the warp goes by no importance, as does that of a uniform map; otherwise null and
   * lifetime as for GetShadowMask.
   */
  virtual vtkImageData* GetImportanceImage(int light, int layer = 0) = 0;

  /**
   * The aliasing error of a light's map (Lloyd et al. 2006, equation 1) on each pixel of the last
   * frame: how wide a texel is on the surface beside a pixel. Two floats: along s and along t, of
   * which the larger counts; above 1 pixels show the texels. 0 where no opaque receiver faces the
   * light within its reach. Null and lifetime as for GetShadowMask.
   */
  virtual vtkImageData* GetAliasingErrorImage(int light) = 0;

  /**
   * The share, 0 to 1, of the pixels that face a light whose shadow is wrong in the last frame, as
   * predicted without exact rays: 0.148 times the sum, over the pixels beside a shadow edge of the
   * frame's mask, of how many pixels the edge moves when what casts it is a texel off, by all
   * pixels that face the light. That goes by the aliasing error along s and t and by how the edge
   * runs, and counts 50 pixels at most. In nine cases of ten the true share is half to one and a
   * half times as large. Any warp, filter and window will do; where no mask was drawn
   * (multisampling, view samples of the previous frame) one is drawn now. 0 where nothing is
   * shadowed, and where shadows are exact; -1 before the first frame, for a light that there isn't,
   * and where the driver can't. Waits for the GPU; frames in which nobody asks cost nothing.
   */
  virtual double GetPredictedError(int light) = 0;

protected:
  vtkInspectableShadowMapPass();
  ~vtkInspectableShadowMapPass() override;

  int DebugView = NONE;
  int DebugLight = 0;
  vtkWeakPointer<vtkLight> NamedDebugLight; ///< null where a number was set

private:
  vtkInspectableShadowMapPass(const vtkInspectableShadowMapPass&) = delete;
  void operator=(const vtkInspectableShadowMapPass&) = delete;
};

#endif
