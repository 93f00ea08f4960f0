#include "tools/panels/gui.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <cmath>

namespace brittle::panels {
namespace {

constexpr float kShortestFrame = 1e-4f;  // ImGui asserts that time goes on [s]

/// Where ImGui looks for a key: its own number serves.
void mapKeys(ImGuiIO& io) {
  for (const ImGuiKey key : {ImGuiKey_LeftArrow, ImGuiKey_RightArrow, ImGuiKey_UpArrow, ImGuiKey_DownArrow,
                             ImGuiKey_Enter, ImGuiKey_Escape, ImGuiKey_Backspace})
    io.KeyMap[key] = key;
}

int keyOf(runtime::Key key) {
  switch (key) {
    case runtime::Key::Left:
      return ImGuiKey_LeftArrow;
    case runtime::Key::Right:
      return ImGuiKey_RightArrow;
    case runtime::Key::Up:
      return ImGuiKey_UpArrow;
    case runtime::Key::Down:
      return ImGuiKey_DownArrow;
    case runtime::Key::Enter:
      return ImGuiKey_Enter;
    case runtime::Key::Escape:
      return ImGuiKey_Escape;
    case runtime::Key::Backspace:
      return ImGuiKey_Backspace;
    default:
      return -1;
  }
}

std::shared_ptr<const render::OverlayTexture> fontTexture(ImGuiIO& io) {
  unsigned char* texels = nullptr;
  auto texture = std::make_shared<render::OverlayTexture>();
  io.Fonts->GetTexDataAsAlpha8(&texels, &texture->width, &texture->height);
  texture->coverage.assign(texels, texels + static_cast<std::ptrdiff_t>(texture->width) * texture->height);
  return texture;
}

void append(const ImDrawList& list, render::Overlay& overlay) {
  const auto firstPoint = static_cast<std::uint32_t>(overlay.points.size());
  const auto firstIndex = static_cast<std::uint32_t>(overlay.indices.size());
  for (const ImDrawVert& vertex : list.VtxBuffer)
    overlay.points.push_back({vertex.pos.x, vertex.pos.y, vertex.uv.x, vertex.uv.y, vertex.col});
  for (const ImDrawIdx index : list.IdxBuffer) overlay.indices.push_back(firstPoint + index);
  for (const ImDrawCmd& command : list.CmdBuffer) {
    const ImVec4& clip = command.ClipRect;
    overlay.parts.push_back({static_cast<int>(std::floor(clip.x)), static_cast<int>(std::floor(clip.y)),
                             static_cast<int>(std::ceil(clip.z)), static_cast<int>(std::ceil(clip.w)),
                             firstIndex + command.IdxOffset, command.ElemCount});
  }
}

/// ImGui itself learns of a touch only with the next frame.
bool isOverAWindow(const ImVec2& place) {
  for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows)
    if (window->WasActive && window->Rect().Contains(place)) return true;
  return false;
}

}  // namespace

Gui::Gui() {
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // where panels stand is not kept
  mapKeys(io);
  overlay_.texture = fontTexture(io);
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 6.0f;
  style.FrameRounding = 3.0f;
  style.GrabRounding = 3.0f;
  style.Colors[ImGuiCol_WindowBg].w = 0.86f;
}

Gui::~Gui() {
  ImGui::DestroyContext();
}

bool Gui::take(const runtime::Event& event) {
  using runtime::EventKind;
  ImGuiIO& io = ImGui::GetIO();
  const bool isPointer = event.kind == EventKind::PointerDown || event.kind == EventKind::PointerMoved ||
                         event.kind == EventKind::PointerUp;
  if (isPointer) {
    io.MousePos = ImVec2(event.x, event.y);
    if (event.kind == EventKind::PointerDown) {
      isDown_ = wasPressed_ = true;
      isOurs_ = isOverAWindow(io.MousePos);
    }
    if (event.kind == EventKind::PointerUp) isDown_ = false;
    return isOurs_;
  }
  if (event.kind != EventKind::KeyDown && event.kind != EventKind::KeyUp) return false;
  if (const int key = keyOf(event.key); key >= 0) io.KeysDown[key] = event.kind == EventKind::KeyDown;
  const bool isLetter = event.key == runtime::Key::Character || event.key == runtime::Key::Space;
  if (io.WantTextInput && isLetter && event.kind == EventKind::KeyDown)
    io.AddInputCharacter(event.key == runtime::Key::Space ? ' ' : static_cast<unsigned char>(event.character));
  return io.WantTextInput;
}

void Gui::begin(runtime::PictureSize size, double seconds) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = ImVec2(static_cast<float>(size.width), static_cast<float>(size.height));
  io.DeltaTime = std::max(static_cast<float>(seconds - lastSeconds_), kShortestFrame);
  lastSeconds_ = seconds;
  io.MouseDown[0] = isDown_ || wasPressed_;
  wasPressed_ = false;
  ImGui::NewFrame();
}

const render::Overlay& Gui::end() {
  ImGui::Render();
  overlay_.clear();
  const ImDrawData& data = *ImGui::GetDrawData();
  for (int i = 0; i < data.CmdListsCount; ++i) append(*data.CmdLists[i], overlay_);
  return overlay_;
}

}  // namespace brittle::panels
