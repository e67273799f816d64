// A framebuffer that is only ever drawn into: depth, with or without one colour image.
#ifndef rtwFramebuffer_h
#define rtwFramebuffer_h

namespace rtw
{
class Texture;

class Framebuffer
{
public:
  Framebuffer() = default;
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;

  /// Makes it the target of drawing, of that layer of each texture, over its whole area. False where
  /// the driver can't draw into the two.
  bool Bind(const Texture& depth, const Texture* colour, int layer = 0);
  /// The same as Bind(), for colour alone.
  bool BindColour(const Texture& colour, int layer = 0);
  /// Clears depth to 1 and the colour image to that value in each component.
  static void Clear(float colour);
  void Release();
  void Abandon() { this->Id = 0; }

private:
  unsigned int Id = 0;
};
}

#endif
