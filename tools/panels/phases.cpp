#include "tools/panels/phases.h"

#include <imgui.h>

#include <algorithm>
#include <cstdio>

namespace brittle::panels {
namespace {

constexpr double kFollow = 0.1;  // share of a new value in the shown one [-]
constexpr double kTickMilliseconds = 16.7;
constexpr double kLeastShown = 0.0005;  // [ms]
constexpr float kBarWidth = 110.0f;     // [pixels]

}  // namespace

void Phases::tickEnds() {
  double total = 0.0;
  for (auto& [name, shown] : shown_) shown *= 1.0 - kFollow;
  for (const auto& [name, ms] : times_.milliseconds()) {
    shown_[name] += kFollow * ms;
    total += ms;
  }
  totals_[next_++ % kRemembered] = static_cast<float>(total);
}

void Phases::show() {
  const float worst = *std::max_element(std::begin(totals_), std::end(totals_));
  const float last = totals_[(next_ + kRemembered - 1) % kRemembered];
  char text[64];
  std::snprintf(text, sizeof text, "%.2f ms, worst of %zu ticks %.2f", static_cast<double>(last), kRemembered,
                static_cast<double>(worst));
  ImGui::PlotHistogram("##ticks", totals_, static_cast<int>(kRemembered), static_cast<int>(next_ % kRemembered), text,
                       0.0f, std::max(worst, 1.0f), ImVec2(ImGui::GetContentRegionAvail().x, 50.0f));
  double most = 1e-3, sum = 0.0;
  for (const auto& [name, ms] : shown_) {
    most = std::max(most, ms);
    sum += ms;
  }
  for (const auto& [name, ms] : shown_) {
    if (ms < kLeastShown) continue;
    ImGui::ProgressBar(static_cast<float>(ms / most), ImVec2(kBarWidth, ImGui::GetFontSize()), "");
    ImGui::SameLine();
    ImGui::Text("%.3f  %s", ms, name.c_str());
  }
  ImGui::Text("%.1f %% of a tick's %.1f ms", 100.0 * sum / kTickMilliseconds, kTickMilliseconds);
}

}  // namespace brittle::panels
