// SPDX-License-Identifier: BSD-3-Clause
// The whole state of the current OpenGL context, as it says itself, to be compared with a later
// one. It needs OpenGL 4.3.
#ifndef rtwStateSnapshot_h
#define rtwStateSnapshot_h

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

class vtkOpenGLRenderWindow;

class rtwStateSnapshot
{
public:
  rtwStateSnapshot();
  /// Names each piece that is other in a later one, with both values; empty if all are the same.
  std::string DifferencesTo(const rtwStateSnapshot& later) const;
  std::size_t GetNumberOfPieces() const { return this->Pieces.size(); }

private:
  void Add(const std::string& name, std::vector<double> values);
  void AddNumbers();
  void AddCapabilities();
  void AddTextures();
  void AddBuffers();
  void AddImages();
  void AddFramebuffers();
  void AddVertexArray();
  void AddQueries();

  std::vector<std::pair<std::string, std::vector<double>>> Pieces;
};

/// Names what vtkOpenGLState remembers wrongly of the state; empty if all is right.
std::string rtwStaleRecords(vtkOpenGLRenderWindow* window);

/// Whether the current context can tell all that.
bool rtwCanTellState();

/// The errors that OpenGL has noted since the last call; empty if there are none.
std::string rtwTakeErrors();

#endif
