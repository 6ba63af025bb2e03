/// @file
/// An OpenGL context with no surface and no display, through EGL.
#pragma once

#include <epoxy/egl.h>

namespace timestep {

/// OpenGL 3.3 core, current in the thread that made it. Tries each graphics card, then
/// Mesa's surfaceless platform, then the default display. Throws InputError
/// ("no off-screen OpenGL: …") if none has it. The display stays open to the program's
/// end: EGL shares it among all who ask, and closing it unloads the driver, which is
/// slow to come back.
class EglContext {
 public:
  EglContext();
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  void make_current() const;

 private:
  bool open(EGLDisplay display);

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace timestep
