#include "common/chapter/studio.hpp"

#include <algorithm>

#include <imgui.h>

#include "common/graphics/palette.hpp"

namespace timestep {

Studio::Studio(glm::ivec2 size)
    : size_(size), context_(size.x, size.y), renderer_(resources_) {}

Image Studio::render(const DrawList& list, const CameraPose& pose,
                     const std::string& banner) {
  CameraPose fitted = pose;
  const float aspect = static_cast<float>(size_.x) / static_cast<float>(size_.y);
  fitted.distance *= std::max(1.0F, 16.0F / 9.0F / aspect);

  context_.begin();
  renderer_.draw(list, Camera(fitted), size_);
  if (!banner.empty()) draw_banner(banner);
  return context_.read();
}

void Studio::draw_banner(const std::string& banner) {
  constexpr float k_scale = 2.5F;
  renderer_.begin_ui(size_, k_scale);
  const float line = ImGui::GetFontSize();
  const ImVec2 place(0.5F * line, static_cast<float>(size_.y) - 1.5F * line);
  const ImVec4 ink(k_ink.r, k_ink.g, k_ink.b, k_ink.a);
  ImGui::GetForegroundDrawList()->AddText(place, ImGui::GetColorU32(ink),
                                          banner.c_str());
  renderer_.end_ui();
}

}  // namespace timestep
