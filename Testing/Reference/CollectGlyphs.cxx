// SPDX-License-Identifier: BSD-3-Clause
#include "rtwCollect.h"

#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkGlyph3DMapper.h>
#include <vtkInformation.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkQuaternion.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>

namespace rtw
{
namespace
{
vtkDataArray* ArrayOf(vtkGlyph3DMapper* glyphs, vtkDataSet* data, int purpose, bool isUsed)
{
  vtkInformation* information = glyphs->GetInputArrayInformation(purpose);
  if (!isUsed || !information)
  {
    return nullptr;
  }
  if (const char* name = information->Get(vtkDataObject::FIELD_NAME()))
  {
    return data->GetPointData()->GetArray(name);
  }
  return data->GetPointData()->GetAttribute(
    information->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE()));
}

double Magnitude(vtkDataArray* array, vtkIdType point)
{
  return vtkMath::Norm(array->GetTuple(point), array->GetNumberOfComponents());
}

// How each glyph of a data set is placed, by the rules of vtkGlyph3DMapper.
class GlyphPlacements
{
public:
  GlyphPlacements(vtkGlyph3DMapper* glyphs, vtkDataSet* data)
    : Glyphs(glyphs)
    , Data(data)
    , Scales(ArrayOf(glyphs, data, vtkGlyph3DMapper::SCALE, glyphs->GetScaling()))
    , Directions(ArrayOf(glyphs, data, vtkGlyph3DMapper::ORIENTATION, glyphs->GetOrient()))
    , Masks(ArrayOf(glyphs, data, vtkGlyph3DMapper::MASK, glyphs->GetMasking()))
    , Sources(ArrayOf(glyphs, data, vtkGlyph3DMapper::SOURCE_INDEX, glyphs->GetSourceIndexing()))
  {
  }

  bool Shows(vtkIdType point) const { return !this->Masks || this->Masks->GetTuple1(point) != 0; }

  int Source(vtkIdType point) const
  {
    if (!this->Sources)
    {
      return 0;
    }
    const int sources = this->Glyphs->GetNumberOfInputConnections(1);
    const double share = this->InRange(Magnitude(this->Sources, point));
    return std::clamp(int(share * sources), 0, sources - 1);
  }

  Placement Place(vtkIdType point, const Placement& outer) const
  {
    double position[3];
    this->Data->GetPoint(point, position);
    glm::dmat3 linear = this->Rotation(point);
    const dvec3 scale = this->Glyphs->GetScaling() ? this->Scale(point) : dvec3(1);
    for (int i = 0; i < 3; ++i)
    {
      linear[i] *= scale[i];
    }
    return { outer.Linear * linear, outer(position) };
  }

private:
  double InRange(double value) const
  {
    const double* range = this->Glyphs->GetRange();
    return (value - range[0]) / (range[1] == range[0] ? 1 : range[1] - range[0]);
  }

  dvec3 Scale(vtkIdType point) const
  {
    dvec3 scale(1);
    const int mode = this->Glyphs->GetScaleMode();
    if (this->Scales && mode != vtkGlyph3DMapper::NO_DATA_SCALING)
    {
      if (mode == vtkGlyph3DMapper::SCALE_BY_MAGNITUDE)
      {
        scale = dvec3(Magnitude(this->Scales, point));
      }
      else if (this->Scales->GetNumberOfComponents() == 3)
      {
        this->Scales->GetTuple(point, &scale.x);
      }
      for (int i = 0; i < 3 && this->Glyphs->GetClamping(); ++i)
      {
        scale[i] = std::clamp(this->InRange(scale[i]), 0.0, 1.0);
      }
    }
    return scale * this->Glyphs->GetScaleFactor();
  }

  glm::dmat3 Rotation(vtkIdType point) const
  {
    const int mode = this->Glyphs->GetOrientationMode();
    const int components = mode == vtkGlyph3DMapper::QUATERNION ? 4 : 3;
    if (!this->Directions || this->Directions->GetNumberOfComponents() != components)
    {
      return glm::dmat3(1);
    }
    double tuple[4] = {};
    this->Directions->GetTuple(point, tuple);
    switch (mode)
    {
      case vtkGlyph3DMapper::ROTATION:
        return About({ 0, 0, 1 }, tuple[2]) * About({ 1, 0, 0 }, tuple[0]) *
          About({ 0, 1, 0 }, tuple[1]);
      case vtkGlyph3DMapper::QUATERNION:
        return Matrix(vtkQuaterniond(tuple));
      default:
        return Along({ tuple[0], tuple[1], tuple[2] });
    }
  }

  // Half a turn about the direction midway between the x axis and this one.
  static glm::dmat3 Along(const dvec3& direction)
  {
    if (direction.y == 0 && direction.z == 0)
    {
      return direction.x < 0 ? About({ 0, 1, 0 }, 180) : glm::dmat3(1);
    }
    return About(glm::normalize(direction + dvec3(glm::length(direction), 0, 0)), 180);
  }

  static glm::dmat3 About(const dvec3& axis, double degrees)
  {
    const double half = vtkMath::RadiansFromDegrees(degrees) / 2;
    const dvec3 v = axis * std::sin(half);
    return Matrix(vtkQuaterniond(std::cos(half), v.x, v.y, v.z));
  }

  static glm::dmat3 Matrix(const vtkQuaterniond& quaternion)
  {
    double rows[3][3];
    quaternion.ToMatrix3x3(rows);
    glm::dmat3 matrix;
    for (int i = 0; i < 3; ++i)
    {
      matrix[i] = dvec3(rows[0][i], rows[1][i], rows[2][i]);
    }
    return matrix;
  }

  vtkGlyph3DMapper* Glyphs;
  vtkDataSet* Data;
  vtkDataArray* Scales;
  vtkDataArray* Directions;
  vtkDataArray* Masks;
  vtkDataArray* Sources;
};

void AddGlyphsOf(vtkGlyph3DMapper* glyphs, vtkDataSet* data, const Placement& placement,
  uint32_t prop, Geometry& to)
{
  const GlyphPlacements placements(glyphs, data);
  for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
  {
    vtkPolyData* source =
      placements.Shows(point) ? glyphs->GetSource(placements.Source(point)) : nullptr;
    if (source && source->GetPoints())
    {
      AddSurface(source, placements.Place(point, placement), prop, to);
    }
  }
}
}

void AddGlyphs(vtkGlyph3DMapper* glyphs, const Placement& placement, uint32_t prop, Geometry& to)
{
  vtkDataObject* input = glyphs->GetInputDataObject(0, 0);
  if (auto* data = vtkDataSet::SafeDownCast(input))
  {
    AddGlyphsOf(glyphs, data, placement, prop, to);
  }
  else if (auto* blocks = vtkCompositeDataSet::SafeDownCast(input))
  {
    const auto each = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
    for (each->InitTraversal(); !each->IsDoneWithTraversal(); each->GoToNextItem())
    {
      if (auto* block = vtkDataSet::SafeDownCast(each->GetCurrentDataObject()))
      {
        AddGlyphsOf(glyphs, block, placement, prop, to);
      }
    }
  }
}
}
