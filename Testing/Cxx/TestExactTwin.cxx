// SPDX-License-Identifier: BSD-3-Clause
// Exact shadows on a floor beside their decision in double precision on the CPU: random triangles,
// fans and stripes of slivers that share edges, through which no light leaks anywhere.
#include "rtwExactTwin.h"
#include "rtwShadowStage.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <random>
#include <vector>

namespace
{
using Corners = std::array<glm::dvec3, 3>;

constexpr double Rounding =
  3e-4; // of places on the floor, in world units: an edge that near isn't told

struct Stage : rtwShadowStage
{
  explicit Stage(const char* name)
    : rtwShadowStage(rtwTechnique::Exact)
  {
    this->Name = name;
    this->Options.Sharp = true;
    this->AddFloor();
    this->Sun = this->AddSun(SunAt.x, SunAt.y, SunAt.z);
  }

  void AddTriangles(const std::vector<Corners>& triangles)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> cells;
    for (const Corners& corners : triangles)
    {
      vtkIdType ids[3];
      for (int k = 0; k < 3; ++k)
      {
        const glm::vec3 rounded(corners[k]); // as the renderer has them
        ids[k] = points->InsertNextPoint(rounded.x, rounded.y, rounded.z);
      }
      cells->InsertNextCell(3, ids);
    }
    vtkNew<vtkPolyData> mesh;
    mesh->SetPoints(points);
    mesh->SetPolys(cells);
    this->Add(mesh.Get());
    this->Triangles = triangles;
  }

  // Compares all pixels of the floor; `leaks` is how many of those in shadow are lit.
  void Compare(int leastShadowed)
  {
    this->Render();
    const std::vector<unsigned char> mask = this->GetMask(0);
    const int* size = this->Renderer->GetSize();
    const std::vector<rtw::ViewSample> samples =
      rtw::ShadowReference(this->Renderer, this->Options).Samples(this->Sun, size[0], size[1]);
    std::vector<rtwTwinCaster<double>> casters;
    for (const Corners& corners : this->Triangles)
    {
      casters.push_back({ OnLight(corners[0]), OnLight(corners[1]), OnLight(corners[2]) });
    }
    int shadowed = 0, lit = 0, leaks = 0, specks = 0;
    for (const rtw::ViewSample& sample : samples)
    {
      if (std::abs(sample.Position.y) > 1e-5)
      {
        continue;
      }
      const int dark = CountDark(casters, sample.Position);
      shadowed += dark == Places;
      lit += dark == 0;
      leaks += dark == Places && mask[sample.Pixel] > rtw::MASK_AVERTED;
      specks += dark == 0 && mask[sample.Pixel] < rtw::MASK_AVERTED;
    }
    std::cout << this->Name << ": of " << shadowed << " pixels in shadow " << leaks
              << " are lit, of " << lit << " in the light " << specks << " dark" << std::endl;
    RTW_CHECK(shadowed > leastShadowed);
    RTW_CHECK(lit > 1000);
    RTW_CHECK_EQUAL(leaks, 0);
    RTW_CHECK_EQUAL(specks, 0);
  }

private:
  static constexpr int Places = 9;
  static inline const glm::dvec3 SunAt{ 1, 5, 0.7 };

  // Straight down in the light's own coordinates.
  static glm::dvec3 OnLight(const glm::dvec3& p)
  {
    const double down = p.y / SunAt.y;
    return { p.x - down * SunAt.x, p.z - down * SunAt.z, -p.y };
  }

  // Of places on the floor around that one.
  static int CountDark(const std::vector<rtwTwinCaster<double>>& casters, const glm::dvec3& at)
  {
    int dark = 0;
    for (int k = 0; k < Places; ++k)
    {
      const double angle = 0.7853981633974483 * k, away = k < 8 ? Rounding : 0;
      const glm::dvec3 s(at.x + away * std::cos(angle), at.z + away * std::sin(angle), 0);
      bool isDark = false;
      for (std::size_t i = 0; i < casters.size() && !isDark; ++i)
      {
        isDark = rtwTwinShadows(casters[i], s);
      }
      dark += isDark;
    }
    return dark;
  }

  vtkLight* Sun;
  std::vector<Corners> Triangles;
};

class Numbers
{
public:
  double Between(double low, double high)
  {
    return low + (high - low) * double(this->Engine()) / double(std::mt19937::max());
  }

private:
  std::mt19937 Engine{ 7 };
};

// A tent of triangles, each as long as some hundreds of its widths.
void TestFan()
{
  Stage stage("fan");
  constexpr int Slices = 1500;
  Numbers random;
  const auto rim = [](int k) {
    const double angle = 2 * 3.14159265358979 * k / Slices;
    return glm::dvec3(2 * std::cos(angle), 0.7 + 0.2 * std::sin(5 * angle), 2 * std::sin(angle));
  };
  std::vector<Corners> triangles;
  for (int k = 0; k < Slices; ++k)
  {
    const Corners corners{ glm::dvec3(0.1, 1.3, 0.2), rim(k), rim((k + 1) % Slices) };
    const int first = int(random.Between(0, 2.999));
    triangles.push_back({ corners[first], corners[(first + 1) % 3], corners[(first + 2) % 3] });
  }
  stage.AddTriangles(triangles);
  stage.Compare(1000);
}

// A plate of stripes, each as long as three thousand of its widths, in two triangles.
void TestStripes()
{
  Stage stage("stripes");
  constexpr int Stripes = 1500;
  std::vector<Corners> triangles;
  const auto at = [](double x, int stripe) {
    return glm::dvec3(x, 0.8 + 0.1 * x, -1 + 1.5 * stripe / Stripes);
  };
  for (int k = 0; k < Stripes; ++k)
  {
    triangles.push_back({ at(-2, k), at(1, k), at(1, k + 1) });
    triangles.push_back({ at(-2, k), at(1, k + 1), at(-2, k + 1) });
  }
  stage.AddTriangles(triangles);
  stage.Compare(1000);
}

// Edges that pass through the centres of pixels exactly: by the light straight above, from a camera
// that looks straight down, below them, each number is known to the last bit.
void TestOnEdges()
{
  rtwShadowStage stage(rtwTechnique::Exact);
  stage.Name = "on edges";
  stage.AddFloor(16);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  constexpr int Cells = 64;
  const auto at = [](int k) { return (2 * k + 1) / 64.0 - 1.0; };
  for (int row = 0; row <= Cells; ++row)
  {
    for (int column = 0; column <= Cells; ++column)
    {
      points->InsertNextPoint(at(column), 4, at(row));
    }
  }
  for (int row = 0; row < Cells; ++row)
  {
    for (int column = 0; column < Cells; ++column)
    {
      const vtkIdType first = row * (Cells + 1) + column, above = first + Cells + 1;
      const vtkIdType low[] = { first, first + 1, above + 1 }, high[] = { first, above + 1, above };
      cells->InsertNextCell(3, low);
      cells->InsertNextCell(3, high);
    }
  }
  vtkNew<vtkPolyData> plate;
  plate->SetPoints(points);
  plate->SetPolys(cells);
  stage.Add(plate.Get());
  stage.AddSun(0, 1, 0);
  // Pixels as wide as the cells, whose centres are their corners.
  stage.Window->SetSize(128, 128);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(2);
  camera->SetPosition(0, 2, 0);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0, 0, 1);
  camera->SetClippingRange(1, 3);
  stage.Window->Render();
  const std::vector<unsigned char> mask = stage.GetMask(0);
  int leaks = 0, lit = 0;
  for (int y = 0; y < 128; ++y)
  {
    for (int x = 0; x < 128; ++x)
    {
      const double column = (x + 0.5) / 32 - 2, row = (y + 0.5) / 32 - 2;
      const bool isUnder = std::max(std::abs(column), std::abs(row)) < 0.96;
      const bool isBeside = std::max(std::abs(column), std::abs(row)) > 1.1;
      leaks += isUnder && mask[std::size_t(y) * 128 + x] > rtw::MASK_AVERTED;
      lit += isBeside && mask[std::size_t(y) * 128 + x] > rtw::MASK_AVERTED;
    }
  }
  std::cout << "on edges: " << leaks << " pixels leak, " << lit << " beside are lit" << std::endl;
  RTW_CHECK_EQUAL(leaks, 0);
  RTW_CHECK(lit > 10000);
}

void TestRandom()
{
  Stage stage("random");
  Numbers random;
  std::vector<Corners> triangles;
  for (int i = 0; i < 150; ++i)
  {
    const auto point = [&](double reach) {
      return glm::dvec3(random.Between(-reach, reach), 0.3 * random.Between(-reach, reach),
        random.Between(-reach, reach));
    };
    const glm::dvec3 a = point(2.5) + glm::dvec3(0, 1.4, 0), along = point(1);
    const double thin = std::pow(10, random.Between(-2.5, 0));
    triangles.push_back({ a, a + along, a + 0.4 * along + thin * point(0.5) });
  }
  stage.AddTriangles(triangles);
  stage.Compare(1000);
}
}

int TestExactTwin(int, char*[])
{
  TestFan();
  TestStripes();
  TestOnEdges();
  TestRandom();
  return rtwTestResult();
}
