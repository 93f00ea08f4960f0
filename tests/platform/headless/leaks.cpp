// Read by the leak checker of sanitised builds only: OSMesa keeps a small buffer for every context it ever made.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libOSMesa\n";
}
