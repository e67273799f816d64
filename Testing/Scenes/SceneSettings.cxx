// SPDX-License-Identifier: BSD-3-Clause
#include "rtwScene.h"

#include <glm/glm.hpp>
#include <vtk_jsoncpp.h>

#include <memory>
#include <stdexcept>

namespace rtw
{
namespace
{
[[noreturn]] void Refuse(const std::string& key, const std::string& expected)
{
  throw std::runtime_error("\"" + key + "\" must be " + expected);
}

void Read(const Json::Value& block, const char* key, double& value)
{
  if (block.isMember(key))
  {
    if (!block[key].isNumeric())
    {
      Refuse(key, "a number");
    }
    value = block[key].asDouble();
  }
}

void Read(const Json::Value& block, const char* key, glm::dvec3& value)
{
  if (!block.isMember(key))
  {
    return;
  }
  const Json::Value& list = block[key];
  for (Json::ArrayIndex i = 0; i < 3; ++i)
  {
    if (!list.isArray() || list.size() != 3 || !list[i].isNumeric())
    {
      Refuse(key, "a list of three numbers");
    }
    value[int(i)] = list[i].asDouble();
  }
}

void ReadSize(const Json::Value& root, int size[2])
{
  if (!root.isMember("size"))
  {
    return;
  }
  const Json::Value& list = root["size"];
  for (Json::ArrayIndex i = 0; i < 2; ++i)
  {
    if (!list.isArray() || list.size() != 2 || !list[i].isInt() || list[i].asInt() < 1)
    {
      Refuse("size", "a list of two whole numbers above zero");
    }
    size[i] = list[i].asInt();
  }
}

void ReadLight(const Json::Value& block, SceneLight& light)
{
  if (block.isMember("type"))
  {
    const std::string type = block["type"].isString() ? block["type"].asString() : std::string();
    if (type != "directional" && type != "spot")
    {
      Refuse("type", "\"directional\" or \"spot\"");
    }
    light.IsSpot = type == "spot";
  }
  Read(block, "position", light.Position);
  Read(block, "direction", light.Direction);
  Read(block, "cone", light.Cone);
  if (glm::length(light.Direction) == 0)
  {
    Refuse("direction", "longer than zero");
  }
  light.Direction = glm::normalize(light.Direction);
}

const Json::Value& Block(const Json::Value& root, const char* key)
{
  const Json::Value& block = root[key];
  if (!block.isNull() && !block.isObject())
  {
    Refuse(key, "an object");
  }
  return block;
}

Json::Value List(const glm::dvec3& v)
{
  Json::Value list(Json::arrayValue);
  for (int i = 0; i < 3; ++i)
  {
    list.append(v[i]);
  }
  return list;
}
}

void ReadSettings(const std::string& json, Scene& scene)
{
  const Json::CharReaderBuilder builder;
  const std::unique_ptr<Json::CharReader> reader(builder.newCharReader());
  Json::Value root;
  std::string errors;
  if (!reader->parse(json.data(), json.data() + json.size(), &root, &errors) || !root.isObject())
  {
    throw std::runtime_error("not a JSON object");
  }
  ReadSize(root, scene.Size);
  const Json::Value& camera = Block(root, "camera");
  Read(camera, "position", scene.Camera.Position);
  Read(camera, "focal", scene.Camera.Focal);
  Read(camera, "up", scene.Camera.Up);
  Read(camera, "angle", scene.Camera.Angle);
  Read(camera, "near", scene.Camera.Near);
  Read(camera, "far", scene.Camera.Far);
  ReadLight(Block(root, "light"), scene.Light);
}

std::string WriteSettings(const Scene& scene)
{
  Json::Value root;
  root["name"] = scene.Name;
  root["size"].append(scene.Size[0]);
  root["size"].append(scene.Size[1]);
  Json::Value& camera = root["camera"];
  camera["position"] = List(scene.Camera.Position);
  camera["focal"] = List(scene.Camera.Focal);
  camera["up"] = List(scene.Camera.Up);
  camera["angle"] = scene.Camera.Angle;
  camera["near"] = scene.Camera.Near;
  camera["far"] = scene.Camera.Far;
  Json::Value& light = root["light"];
  light["type"] = scene.Light.IsSpot ? "spot" : "directional";
  light["direction"] = List(scene.Light.Direction);
  light["position"] = List(scene.Light.Position);
  light["cone"] = scene.Light.Cone;
  return Json::writeString(Json::StreamWriterBuilder(), root) + "\n";
}
}
