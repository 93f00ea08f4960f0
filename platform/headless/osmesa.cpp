#define GL_GLEXT_LEGACY  // osmesa.h brings the desktop header; we only want its types
#include <GL/osmesa.h>

#include <array>

#include "platform/headless/context.h"
#include "platform/headless/library.h"

namespace brittle::platform {

namespace {

// OSMesa insists on a picture of its own; all drawing goes to framebuffer objects, so the smallest will do.
constexpr int kFormalSize = 4;

struct OsMesa {
  decltype(&OSMesaCreateContextAttribs) createContext = nullptr;
  decltype(&OSMesaDestroyContext) destroyContext = nullptr;
  decltype(&OSMesaMakeCurrent) makeCurrent = nullptr;
  decltype(&OSMesaGetProcAddress) getProcAddress = nullptr;
};

OsMesa loadedOsMesa;  // the GL loader is a plain function and needs it

Status loadOsMesa() {
  const Result<Library> library = Library::open("libOSMesa.so.8", "libosmesa6");
  if (!library) return library.error();
  OsMesa& mesa = loadedOsMesa;
  mesa.createContext = library->find<decltype(mesa.createContext)>("OSMesaCreateContextAttribs");
  mesa.destroyContext = library->find<decltype(mesa.destroyContext)>("OSMesaDestroyContext");
  mesa.makeCurrent = library->find<decltype(mesa.makeCurrent)>("OSMesaMakeCurrent");
  mesa.getProcAddress = library->find<decltype(mesa.getProcAddress)>("OSMesaGetProcAddress");
  if (mesa.createContext == nullptr || mesa.destroyContext == nullptr || mesa.makeCurrent == nullptr ||
      mesa.getProcAddress == nullptr) {
    return Error{"libOSMesa.so.8 is too old: apt-get install libosmesa6"};
  }
  return Done{};
}

void* findInOsMesa(const char* name) {
  return reinterpret_cast<void*>(loadedOsMesa.getProcAddress(name));
}

class OsMesaHolder : public Context {
 public:
  explicit OsMesaHolder(OSMesaContext context) : context_(context) {}
  ~OsMesaHolder() override {
    loadedOsMesa.makeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    loadedOsMesa.destroyContext(context_);
  }
  runtime::GlLoader loader() const override { return findInOsMesa; }
  bool makeCurrent() {
    return loadedOsMesa.makeCurrent(context_, picture_.data(), GL_UNSIGNED_BYTE, kFormalSize, kFormalSize) != GL_FALSE;
  }

 private:
  OSMesaContext context_;
  std::array<unsigned char, 4 * kFormalSize * kFormalSize> picture_{};
};

}  // namespace

Result<std::unique_ptr<Context>> createOsMesaContext() {
  const Status loaded = loadOsMesa();
  if (!loaded) return loaded.error();
  const int wanted[] = {OSMESA_FORMAT,
                        OSMESA_RGBA,
                        OSMESA_PROFILE,
                        OSMESA_CORE_PROFILE,
                        OSMESA_CONTEXT_MAJOR_VERSION,
                        3,
                        OSMESA_CONTEXT_MINOR_VERSION,
                        3,
                        0};
  OSMesaContext context = loadedOsMesa.createContext(wanted, nullptr);
  if (context == nullptr) return Error{"OSMesa: no core profile context"};
  std::unique_ptr<OsMesaHolder> holder(new OsMesaHolder(context));
  if (!holder->makeCurrent()) return Error{"OSMesa: the context cannot be made current"};
  return std::unique_ptr<Context>(std::move(holder));
}

}  // namespace brittle::platform
