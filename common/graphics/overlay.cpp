#include "common/graphics/overlay.hpp"

#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_opengl3.h>

#include "common/graphics/input_error.hpp"
#include "common/graphics/resource_manager.hpp"

namespace timestep {
namespace {

constexpr float k_font_size = 15;

// What the panels may say beyond Latin letters
constexpr ImWchar k_letters[] = {0x0020, 0x00FF, 0x0370, 0x03FF, 0x2010, 0x2027, 0x2070,
                                 0x209C, 0x2190, 0x2199, 0x2200, 0x22FF, 0};

}  // namespace

void Overlay::ContextDeleter::operator()(ImGuiContext* context) const {
  ImGui::DestroyContext(context);
}

Overlay::Overlay(GLFWwindow* window)
    : window_(window), context_(ImGui::CreateContext()) {
  ImGui::SetCurrentContext(context_.get());
  ImGui::GetIO().IniFilename = nullptr;
  ImGui::GetIO().LogFilename = nullptr;
  if (window != nullptr) ImGui_ImplGlfw_InitForOpenGL(window, true);
  if (!ImGui_ImplOpenGL3_Init("#version 330 core")) {
    throw InputError("no panel: Dear ImGui found no OpenGL");
  }
}

Overlay::~Overlay() {
  ImGui::SetCurrentContext(context_.get());
  ImGui_ImplOpenGL3_Shutdown();
  if (window_ != nullptr) ImGui_ImplGlfw_Shutdown();
}

void Overlay::rescale(float scale) {
  if (scale == scale_) return;
  scale_ = scale;

  // The font at its very size, and all distances from their unscaled values
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  fonts.Clear();
  const std::string file = find_asset("fonts", "DejaVuSans.ttf").string();
  if (std::filesystem::exists(file)) {
    fonts.AddFontFromFileTTF(file.c_str(), k_font_size * scale, nullptr, k_letters);
  }
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();

  ImGuiStyle style;
  ImGui::StyleColorsLight(&style);
  style.WindowRounding = 6;
  style.FrameRounding = 4;
  style.Colors[ImGuiCol_WindowBg].w = 0.92F;
  style.ScaleAllSizes(scale);
  ImGui::GetStyle() = style;
}

void Overlay::begin(glm::ivec2 size, float scale) {
  ImGui::SetCurrentContext(context_.get());
  rescale(scale);
  ImGui_ImplOpenGL3_NewFrame();
  if (window_ != nullptr) {
    ImGui_ImplGlfw_NewFrame();
  } else {
    ImGui::GetIO().DisplaySize = {static_cast<float>(size.x),
                                  static_cast<float>(size.y)};
    ImGui::GetIO().DeltaTime = 1.0F / 60;
  }
  ImGui::NewFrame();
}

void Overlay::end() {
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace timestep
