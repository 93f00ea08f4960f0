#include "tools/callgrind/shell.h"

#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <memory>

namespace brittle::callgrind {
namespace {

std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string lastLineOf(const std::string& text) {
  const std::size_t end = text.find_last_not_of('\n');
  if (end == std::string::npos) return "no word of why";
  const std::size_t begin = text.rfind('\n', end);
  return text.substr(begin == std::string::npos ? 0 : begin + 1, end - (begin == std::string::npos ? 0 : begin));
}

}  // namespace

Result<std::string> outputOf(const std::vector<std::string>& words) {
  std::string command;
  for (const std::string& word : words) command += quoted(word) + " ";
  std::FILE* pipe = popen((command + "2>&1").c_str(), "r");
  if (pipe == nullptr) return Error{words[0] + ": cannot be started"};
  std::string text;
  char buffer[4096];
  while (const std::size_t got = std::fread(buffer, 1, sizeof buffer, pipe)) text.append(buffer, got);
  const int status = pclose(pipe);
  if (status != 0) return Error{words[0] + ": " + lastLineOf(text)};
  return text;
}

bool isThere(const std::string& program) {
  return static_cast<bool>(outputOf({"sh", "-c", "command -v " + program}));
}

Result<double> numberAfter(const std::string& text, const std::string& name) {
  const std::size_t at = text.find(name);
  const std::size_t digits = at == std::string::npos ? at : text.find_first_of("0123456789-", at + name.size());
  if (digits == std::string::npos) return Error{"no number called " + name};
  return std::strtod(text.c_str() + digits, nullptr);
}

}  // namespace brittle::callgrind
