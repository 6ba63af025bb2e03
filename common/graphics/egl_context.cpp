#if __has_include(<epoxy/egl.h>)
#include "common/graphics/egl_context.hpp"

#include <array>
#include <cstdlib>
#include <string_view>
#include <vector>

#include <dlfcn.h>
#include <epoxy/gl.h>

#include "common/graphics/input_error.hpp"

namespace timestep {
namespace {

/// A function of an EGL extension, or null. Asked for by hand since there is no display
/// yet whose extensions a loader could check.
template <class Function>
Function extension(const char* function) {
  return reinterpret_cast<Function>(eglGetProcAddress(function));
}

bool has_word(const char* words, std::string_view word) {
  return words != nullptr
         && std::string_view(words).find(word) != std::string_view::npos;
}

bool loadable(const char* library) {
  return dlopen(library, RTLD_LAZY) != nullptr;
}

/// Refuses what libepoxy would end the program over.
void require_libraries() {
  if (!loadable("libEGL.so.1")) {
    throw InputError("no off-screen OpenGL: libEGL.so.1 cannot be loaded");
  }
  if (!loadable("libOpenGL.so.0") && !loadable("libGL.so.1")) {
    throw InputError("no off-screen OpenGL: libOpenGL.so.0 cannot be loaded");
  }
  setenv("EGL_LOG_LEVEL", "fatal", 0);  // it is for us to say what is missing
}

/// The displays of graphics cards; those in software are left to Mesa's platform.
std::vector<EGLDisplay> card_displays() {
  const auto devices_of = extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  const auto describe =
      extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
  const auto display_of =
      extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  if (devices_of == nullptr || describe == nullptr || display_of == nullptr) return {};

  std::array<EGLDeviceEXT, 16> devices{};
  EGLint count = 0;
  devices_of(static_cast<EGLint>(devices.size()), devices.data(), &count);
  std::vector<EGLDisplay> displays;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    if (has_word(describe(devices[i], EGL_EXTENSIONS), "software")) continue;
    displays.push_back(display_of(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
  }
  return displays;
}

/// Mesa's display without a display, then whatever is the default.
std::vector<EGLDisplay> other_displays() {
  std::vector<EGLDisplay> displays;
  const auto display_of =
      extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  if (display_of != nullptr
      && has_word(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS),
                  "EGL_MESA_platform_surfaceless")) {
    displays.push_back(
        display_of(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  }
  displays.push_back(eglGetDisplay(EGL_DEFAULT_DISPLAY));
  return displays;
}

EGLContext create_context(EGLDisplay display) {
  const EGLint config_attributes[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE,
                                      EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (eglBindAPI(EGL_OPENGL_API) == 0
      || eglChooseConfig(display, config_attributes, &config, 1, &count) == 0
      || count == 0) {
    return EGL_NO_CONTEXT;
  }
  const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION_KHR,
                               3,
                               EGL_CONTEXT_MINOR_VERSION_KHR,
                               3,
                               EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR,
                               EGL_NONE};
  return eglCreateContext(display, config, EGL_NO_CONTEXT, attributes);
}

}  // namespace

EglContext::EglContext() {
  require_libraries();
  for (EGLDisplay display : card_displays()) {
    if (open(display)) return;
  }
  for (EGLDisplay display : other_displays()) {
    if (open(display)) return;
  }
  throw InputError("no off-screen OpenGL: no EGL display gives OpenGL 3.3 core");
}

EglContext::~EglContext() {
  if (eglGetCurrentContext() == context_) {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
  eglDestroyContext(display_, context_);
}

bool EglContext::open(EGLDisplay display) {
  if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == 0) {
    return false;
  }
  display_ = display;
  context_ = create_context(display);
  if (context_ == EGL_NO_CONTEXT) return false;
  if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != 0)
    return true;
  eglDestroyContext(display, context_);
  return false;
}

void EglContext::make_current() const {
  if (eglGetCurrentContext() == context_) return;
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
}

}  // namespace timestep
#endif
