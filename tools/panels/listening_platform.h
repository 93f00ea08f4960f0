// panels/listening_platform.h - a platform whose events somebody else hears first: panels and keys that the game's loop
// knows nothing of.
#pragma once

#include <functional>
#include <utility>

#include "engine/runtime/platform.h"

namespace brittle::panels {

class ListeningPlatform : public runtime::Platform {
 public:
  /// True: the event ends with the listener.
  using Listener = std::function<bool(const runtime::Event&)>;

  /// `inner` must outlive it.
  ListeningPlatform(runtime::Platform& inner, Listener listener) : inner_(inner), listener_(std::move(listener)) {}

  runtime::PictureSize size() const override { return inner_.size(); }
  void pollEvents(std::vector<runtime::Event>& events) override {
    heard_.clear();
    inner_.pollEvents(heard_);
    for (const runtime::Event& event : heard_)
      if (!listener_(event)) events.push_back(event);
  }
  void swap() override { inner_.swap(); }
  runtime::GlLoader glLoader() const override { return inner_.glLoader(); }
  bool hasDefaultFramebuffer() const override { return inner_.hasDefaultFramebuffer(); }
  double seconds() const override { return inner_.seconds(); }
  void sleep(double seconds) override { inner_.sleep(seconds); }

 private:
  runtime::Platform& inner_;
  Listener listener_;
  std::vector<runtime::Event> heard_;
};

}  // namespace brittle::panels
