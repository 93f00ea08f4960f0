// Read by the leak checker of sanitised builds only: SDL unloads the GL driver, so what that keeps cannot be told apart
// by name.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() {
  return "detect_leaks=0";
}
