// SPDX-License-Identifier: BSD-3-Clause
// A scene in a window with shadows, and how far its masks and its picture are from exact rays:
//
//     rtwShadowStage stage(rtwTechnique::RTW);
//     stage.AddFloor();
//     vtkActor* ball = stage.AddBall(0, 1.2, 0, 1);
//     vtkLight* sun = stage.AddSun(2, 4, 1);
//     stage.Render();
//     RTW_CHECK_SHADOWS(stage, sun, 0);
//     RTW_CHECK_PICTURE(stage);
#ifndef rtwShadowStage_h
#define rtwShadowStage_h

#include "rtwTest.h"

#include "rtwCompare.h"

#include "vtkActor.h"
#include "vtkAdaptiveShadowMapPass.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkAlgorithm;
class vtkPolyData;
class vtkShadowRenderStepsPass;

enum class rtwTechnique
{
  Unfocused,
  Uniform,
  RTW,
  NoTW,
  Perspective,
  Exact,
  Cascades
};

enum class rtwChain
{
  Steps,  ///< vtkShadowRenderStepsPass
  Classic ///< baker and pass in a sequence
};

vtkSmartPointer<vtkAdaptiveShadowMapPass> rtwMakePass(rtwTechnique technique);
/// As users of VTK's own passes write it.
vtkSmartPointer<vtkRenderPass> rtwMakeClassicChain(vtkAdaptiveShadowMapPass* shadows);

/// Shares of the pixels that face the light, in percent.
struct rtwShadowBounds
{
  double Wrong = 0.15;
  double Far = 0.01;      ///< wrong, and not within two pixels of an edge
  double Undecided = 0.1; ///< the mask has no decision there
  double Stray = 0.02;    ///< of all pixels: a decision on what is averted, away from its borders
  double Shadowed = 2.0;  ///< at least, in truth: else the scene shows nothing
};

class rtwShadowStage
{
public:
  explicit rtwShadowStage(
    rtwTechnique technique = rtwTechnique::RTW, rtwChain chain = rtwChain::Steps);
  explicit rtwShadowStage(vtkAdaptiveShadowMapPass* pass, rtwChain chain = rtwChain::Steps);
  ~rtwShadowStage();
  rtwShadowStage(const rtwShadowStage&) = delete;
  void operator=(const rtwShadowStage&) = delete;

  /// In white, not specular.
  vtkActor* Add(vtkAlgorithm* source);
  vtkActor* Add(vtkPolyData* mesh);
  vtkActor* AddFloor(double side = 12);
  vtkActor* AddBall(double x, double y, double z, double radius, int resolution = 24);
  vtkActor* AddBox(double x, double y, double z, double side);
  /// A directional light, from there to the origin.
  vtkLight* AddSun(double x, double y, double z);
  vtkLight* AddSpot(double x, double y, double z, double cone = 35);
  /// Floor, ball and box, which all tests of something else than meshes look at, and no light.
  void AddObjects();

  /// One frame.
  void Render();
  void UsePass(bool use);

  /// What exact rays meet instead of an actor that they know nothing of.
  void SetStandIn(vtkActor* actor, vtkPolyData* mesh);

  ///@{
  /// A mask of the pass, in VTK's order; empty if there is none. What is exact for it.
  std::vector<unsigned char> GetMask(int index);
  rtw::Truth Trace(vtkLight* light);
  ///@}
  /// Checks the mask of a light, which is the one with that number among those with shadows.
  bool Check(vtkLight* light, int index, const rtwShadowBounds& bounds, const char* file, int line);
  /// Checks that the picture is the sum of what each light gives without shadows, times its exact
  /// shadow; tells how many percent of the pixels away from edges differ. Draws further pictures.
  bool CheckPicture(double percent, const char* file, int line);

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkAdaptiveShadowMapPass> Pass;
  rtw::ReferenceOptions Options;
  std::string Name; ///< what is being looked at, for messages

private:
  struct StandIn
  {
    vtkActor* Actor;
    vtkActor* Exact;
  };
  rtw::ShadowReference MakeReference();

  vtkSmartPointer<vtkRenderPass> Chain;
  std::vector<StandIn> StandIns;
};

#define RTW_CHECK_SHADOWS(stage, light, index)                                                     \
  (stage).Check((light), (index), rtwShadowBounds(), __FILE__, __LINE__)
#define RTW_CHECK_SHADOWS_WITHIN(stage, light, index, bounds)                                      \
  (stage).Check((light), (index), (bounds), __FILE__, __LINE__)
#define RTW_CHECK_PICTURE(stage) (stage).CheckPicture(0.1, __FILE__, __LINE__)

#endif
