// SPDX-License-Identifier: BSD-3-Clause
// Exact shadows of random scenes beside exact rays: solids that stand on each other or go through
// each other, slivers, stacks of plates that all but touch, seen from anywhere, by any light. 24
// scenes; 200 with the argument `all`.
#include "rtwShadowStage.h"
#include "rtwWrongPixels.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkConeSource.h"
#include "vtkCubeSource.h"
#include "vtkCylinderSource.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkSuperquadricSource.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <string>

namespace
{
class RandomScene
{
public:
  explicit RandomScene(unsigned int seed)
    : Numbers(seed)
  {
    this->Stage.Name = "scene " + std::to_string(seed);
    this->Stage.Options.Sharp = true;
    this->Stage.AddFloor(this->Between(10, 40));
    const int things = this->Whole(4, 14);
    for (int i = 0; i < things; ++i)
    {
      this->AddThing();
    }
    this->AddLight();
    this->PlaceCamera();
  }

  rtw::ShadowErrors Measure()
  {
    this->Stage.Pass->SetResolution(this->Whole(0, 1) ? 1024 : 200);
    this->Stage.Render();
    const rtw::Truth truth = this->Stage.Trace(this->Light);
    const std::vector<unsigned char> mask = this->Stage.GetMask(0);
    this->OtherSurfaces = rtwCountOtherSurfaces(this->Stage.Window, mask, truth);
    return rtw::Compare(mask, truth);
  }

  const std::string& Name() const { return this->Stage.Name; }

  int OtherSurfaces = 0; ///< that wrong pixels show, not the one that the exact ray meets

private:
  double Between(double low, double high)
  {
    return low + (high - low) * double(this->Numbers()) / double(std::mt19937::max());
  }
  int Whole(int low, int high) { return low + int(this->Numbers() % (high - low + 1)); }

  template <class Source>
  void Place(Source* source)
  {
    vtkActor* actor = this->Stage.Add(source);
    actor->SetPosition(this->Between(-3, 3), this->Between(0, 2.5), this->Between(-3, 3));
    actor->RotateWXYZ(
      this->Between(0, 360), this->Between(-1, 1), this->Between(-1, 1), this->Between(0.1, 1));
    actor->SetScale(this->Between(0.3, 1.5), this->Between(0.3, 1.5), this->Between(0.3, 1.5));
  }

  void AddThing()
  {
    switch (this->Whole(0, 6))
    {
      case 0:
      {
        vtkNew<vtkSphereSource> ball;
        ball->SetThetaResolution(this->Whole(5, 150));
        ball->SetPhiResolution(this->Whole(5, 150));
        return this->Place(ball.Get());
      }
      case 1:
      {
        vtkNew<vtkConeSource> cone;
        cone->SetResolution(this->Whole(3, 60));
        return this->Place(cone.Get());
      }
      case 2:
      {
        vtkNew<vtkCylinderSource> cylinder;
        cylinder->SetResolution(this->Whole(3, 60));
        return this->Place(cylinder.Get());
      }
      case 3:
      {
        vtkNew<vtkSuperquadricSource> source;
        source->ToroidalOn();
        source->SetThickness(this->Between(0.1, 0.6));
        source->SetThetaResolution(4 * this->Whole(3, 20));
        source->SetPhiResolution(4 * this->Whole(3, 20));
        return this->Place(source.Get());
      }
      case 4:
        return this->AddSlivers();
      case 5:
        return this->AddPlates();
      default:
        this->Stage.AddBox(
          this->Between(-3, 3), this->Between(0, 2), this->Between(-3, 3), this->Between(0.2, 2));
    }
  }

  // Triangles a thousand times as long as wide.
  void AddSlivers()
  {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    for (int i = 0; i < 60; ++i)
    {
      const double x = this->Between(-3, 3), y = this->Between(0.01, 3), z = this->Between(-3, 3);
      const double dx = this->Between(-3, 3), dy = this->Between(-1, 1), dz = this->Between(-3, 3);
      const vtkIdType first = points->InsertNextPoint(x, y, z);
      points->InsertNextPoint(x + dx, y + dy, z + dz);
      points->InsertNextPoint(x + 0.003, y + 0.002, z - 0.003);
      cells->InsertNextCell({ first, first + 1, first + 2 });
    }
    vtkNew<vtkPolyData> slivers;
    slivers->SetPoints(points);
    slivers->SetPolys(cells);
    this->Stage.Add(slivers);
  }

  void AddPlates()
  {
    const double x = this->Between(-2, 2), y = this->Between(0, 2), z = this->Between(-2, 2);
    const double gap = 0.02 * std::pow(10, -this->Between(0, 1));
    for (int i = 0; i < 5; ++i)
    {
      vtkNew<vtkCubeSource> plate;
      plate->SetBounds(
        x, x + 1.5 - 0.1 * i, y + (i + 1) * gap, y + (i + 1) * gap + 0.002, z, z + 1.2);
      this->Stage.Add(plate);
    }
  }

  void AddLight()
  {
    const double angle = this->Between(0, 6.28);
    const double high = this->Between(0.5, 6);
    const double x = 5 * std::cos(angle), z = 5 * std::sin(angle);
    this->Light = this->Whole(0, 2) == 0
      ? this->Stage.AddSpot(x, high + 2, z, this->Between(20, 60))
      : this->Stage.AddSun(x, high, z);
  }

  void PlaceCamera()
  {
    const double angle = this->Between(0, 6.28), away = this->Between(4, 12);
    vtkCamera* camera = this->Stage.Renderer->GetActiveCamera();
    camera->SetPosition(away * std::cos(angle), this->Between(0.5, 7), away * std::sin(angle));
    camera->SetFocalPoint(this->Between(-1, 1), 0.5, this->Between(-1, 1));
    camera->SetViewAngle(this->Between(20, 70));
    camera->SetParallelProjection(this->Whole(0, 4) == 0);
    camera->SetParallelScale(this->Between(1.5, 5));
    this->Stage.Renderer->ResetCameraClippingRange();
  }

  std::mt19937 Numbers;
  rtwShadowStage Stage{ rtwTechnique::Exact };
  vtkLight* Light = nullptr;
};
}

int TestExactRandom(int argc, char* argv[])
{
  const bool all = argc > 1 && std::string(argv[1]) == "all";
  rtw::ShadowErrors sum;
  double worst = 0;
  int others = 0;
  for (unsigned int seed = 1; seed <= (all ? 200u : 24u); ++seed)
  {
    RandomScene scene(seed);
    const rtw::ShadowErrors errors = scene.Measure();
    if (errors.Wrong() > 0)
    {
      std::cout << scene.Name() << ": " << errors.WronglyDark << " wrongly dark, "
                << errors.WronglyLit << " wrongly lit, " << errors.FarFromEdge
                << " far from edges, of " << errors.LitFacing << std::endl;
    }
    worst = std::max(worst, errors.Percent(errors.Wrong()));
    sum += errors;
    others += scene.OtherSurfaces;
  }
  std::cout << sum.Wrong() << " wrong (" << sum.WronglyDark << " dark) of " << sum.LitFacing << ": "
            << sum.Percent(sum.Wrong()) << " %, " << sum.FarFromEdge << " far from edges, "
            << sum.Percent(sum.NotComparable) << " % undecided; worst " << worst
            << " %; another surface at " << others << std::endl;
  RTW_CHECK(sum.LitFacing > 500000);
  RTW_CHECK(sum.Percent(sum.Shadowed) > 2);
  RTW_CHECK(sum.Percent(sum.Wrong()) < 0.01);
  RTW_CHECK(sum.Percent(sum.FarFromEdge) < 0.001);
  RTW_CHECK(sum.Percent(sum.NotComparable) < 0.1);
  RTW_CHECK(worst < 0.05);
  return rtwTestResult();
}
