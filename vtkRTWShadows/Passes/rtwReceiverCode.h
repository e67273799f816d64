// SPDX-License-Identifier: BSD-3-Clause
// Which code the mappers of a prop draw with, and what they know it by.
#ifndef rtwReceiverCode_h
#define rtwReceiverCode_h

#include "Lookup/rtwReceiverShader.h"

#include "vtkOpenGLRenderPass.h"
#include "vtkSmartPointer.h"

#include <string>

namespace rtw
{
/// No more of the shape than the code depends on, so that different techniques mostly have the same.
struct ReceiverCode
{
  ReceiverShape Shape;
  Receiving Way = Receiving::Direct;
  bool DrawsItself = false; ///< the mapper has a part in the light pass and the view samples too

  static ReceiverCode Make(const ReceiverShape& shape, Receiving way, bool drawsItself);
  /// A name that differs for different code.
  std::string GetName() const;
};

/// Stands for a piece of code in the keys of props. A mapper builds its shaders anew whenever it
/// finds another object there than the last time, so there is one for each code, whichever pass in
/// whichever viewport draws with it; what the mapper asks of it, that pass answers.
class ReceiverCodePass : public vtkOpenGLRenderPass
{
public:
  static ReceiverCodePass* New();
  vtkTypeMacro(ReceiverCodePass, vtkOpenGLRenderPass);

  /// The pass for code of that name, or for several: the one that there is while somebody holds it,
  /// or a new one.
  static vtkSmartPointer<ReceiverCodePass> Of(const std::string& name);

  /// While one lives, that pass answers.
  class Answering
  {
  public:
    explicit Answering(vtkOpenGLRenderPass* pass);
    ~Answering();
    Answering(const Answering&) = delete;
    Answering& operator=(const Answering&) = delete;

  private:
    vtkOpenGLRenderPass* Before;
  };

  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;
  vtkMTimeType GetShaderStageMTime() override;
  void Render(const vtkRenderState*) override {}

protected:
  ReceiverCodePass() = default;
  ~ReceiverCodePass() override = default;

private:
  ReceiverCodePass(const ReceiverCodePass&) = delete;
  void operator=(const ReceiverCodePass&) = delete;
};
}

#endif
