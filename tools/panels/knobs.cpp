#include "tools/panels/knobs.h"

#include <imgui.h>

#include <string>

namespace brittle::panels {
namespace {

using physics::Accuracy;

bool whole(const char* name, std::int32_t& value, int low, int high) {
  return ImGui::SliderInt(name, &value, low, high, "%d", ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
}

bool real(const char* name, float& value, float low, float high, const char* format) {
  return ImGui::SliderFloat(name, &value, low, high, format, ImGuiSliderFlags_AlwaysClamp);
}

/// Enumerators that count from 0.
template <class Enum>
bool choice(const char* name, Enum& value, const char* namesBetweenZeros) {
  int index = static_cast<int>(value);
  const bool isChanged = ImGui::Combo(name, &index, namesBetweenZeros);
  value = static_cast<Enum>(index);
  return isChanged;
}

bool presets(Accuracy& accuracy) {
  bool isChanged = false;
  for (const std::string_view name : physics::presetNames()) {
    if (ImGui::Button(std::string(name).c_str())) {
      accuracy = *physics::preset(name);
      isChanged = true;
    }
    ImGui::SameLine();
  }
  ImGui::NewLine();
  return isChanged;
}

bool breaking(Accuracy& a) {
  bool isChanged = choice("breaks", a.fractureMode, "inside the step\0after it\0after it, blended\0");
  isChanged |= whole("rounds (0: all)", a.fractureRounds, 0, 64);
  isChanged |= whole("fast rounds", a.fastRounds, 0, 64);
  isChanged |= ImGui::Checkbox("impulse cap", &a.impulseCap);
  isChanged |= real("blend", a.blend, 0.0f, 1.0f, "%.2f");
  isChanged |= real("pattern density", a.patternDensity, 0.1f, 10.0f, "%.2f");
  isChanged |= real("least volume", a.minVolumeScale, 0.0f, 1000.0f, "%.0f");
  isChanged |= whole("debris", a.maxDebris, 0, 10'000);
  return isChanged | whole("bodies", a.maxBodies, 0, 10'000);
}

bool solving(Accuracy& a) {
  bool isChanged = whole("iterations", a.iterations, 1, 1000);
  isChanged |= whole("push-out iterations", a.positionIterations, 0, 100);
  isChanged |= whole("substeps", a.substeps, 1, 64);
  isChanged |= ImGui::Checkbox("piles stand", &a.stacks);
  isChanged |= choice("manifold", a.manifold.kind, "incremental\0clipped\0");
  isChanged |= real("speculative margin", a.speculativeMargin, 0.0f, 0.2f, "%.3f m");
  isChanged |= real("direct mass ratio", a.directSolveMassRatio, 0.0f, 1000.0f, "%.0f");
  isChanged |= ImGui::Checkbox("warm start", &a.warmStart);
  return isChanged | ImGui::Checkbox("deactivation", &a.deactivation);
}

}  // namespace

bool showKnobs(Accuracy& accuracy) {
  ImGui::PushItemWidth(ImGui::GetFontSize() * 9.0f);
  bool isChanged = presets(accuracy);
  isChanged |= breaking(accuracy);
  isChanged |= solving(accuracy);
  ImGui::PopItemWidth();
  return isChanged;
}

}  // namespace brittle::panels
