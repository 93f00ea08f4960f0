#include "platform/headless/headless.h"

#include <chrono>
#include <thread>

#include "platform/headless/context.h"

namespace brittle::platform {

namespace {

using Clock = std::chrono::steady_clock;

class HeadlessPlatform : public Headless {
 public:
  HeadlessPlatform(std::unique_ptr<Context> context, runtime::PictureSize size)
      : context_(std::move(context)), size_(size) {}

  runtime::PictureSize size() const override { return size_; }
  void pollEvents(std::vector<runtime::Event>& events) override {
    events.insert(events.end(), pending_.begin(), pending_.end());
    pending_.clear();
  }
  void swap() override {}
  runtime::GlLoader glLoader() const override { return context_->loader(); }
  bool hasDefaultFramebuffer() const override { return false; }
  double seconds() const override { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  void sleep(double seconds) override { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }
  void send(const runtime::Event& event) override {
    if (event.kind == runtime::EventKind::Resized) size_ = {event.width, event.height};
    pending_.push_back(event);
  }

 private:
  std::unique_ptr<Context> context_;
  runtime::PictureSize size_;
  std::vector<runtime::Event> pending_;
  Clock::time_point start_ = Clock::now();
};

Result<std::unique_ptr<Context>> createContext(HeadlessBackend backend) {
  switch (backend) {
    case HeadlessBackend::Egl:
      return createEglContext();
    case HeadlessBackend::OsMesa:
      return createOsMesaContext();
    case HeadlessBackend::Null:
      break;
  }
  return createNullContext();
}

}  // namespace

const char* nameOf(HeadlessBackend backend) {
  switch (backend) {
    case HeadlessBackend::Egl:
      return "egl";
    case HeadlessBackend::OsMesa:
      return "osmesa";
    case HeadlessBackend::Null:
      return "null";
  }
  return "";
}

Result<std::unique_ptr<Headless>> createHeadless(HeadlessBackend backend, runtime::PictureSize size) {
  if (size.width <= 0 || size.height <= 0) {
    return Error{"picture size " + std::to_string(size.width) + " x " + std::to_string(size.height) +
                 ": both must be at least 1 pixel"};
  }
  Result<std::unique_ptr<Context>> context = createContext(backend);
  if (!context) return context.error();
  return std::unique_ptr<Headless>(new HeadlessPlatform(std::move(*context), size));
}

}  // namespace brittle::platform
