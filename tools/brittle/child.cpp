#include "tools/brittle/child.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

#include "tools/brittle/interrupt.h"

namespace brittle::program {

Result<std::unique_ptr<Child>> Child::start(const std::vector<std::string>& words, const std::string& package) {
  std::signal(SIGPIPE, SIG_IGN);  // a child that ends early is an error to report, not the end of this program
  std::unique_ptr<Child> child(new Child);
  const Status launched = child->launch(words, package);
  if (!launched) return launched.error();
  return child;
}

Status Child::launch(const std::vector<std::string>& words, const std::string& package) {
  name_ = words[0];
  complaints_ = std::tmpfile();
  int ends[2];
  if (complaints_ == nullptr || pipe2(ends, O_CLOEXEC) != 0)
    return Error{name_ + " cannot be run: " + std::strerror(errno)};
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, ends[0], STDIN_FILENO);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&files, fileno(complaints_), STDERR_FILENO);
  const int problem = posix_spawnp(&process_, arguments[0], &files, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  close(ends[0]);
  input_ = ends[1];
  if (problem == 0) {
    endOnInterrupt(process_);
    return Done{};
  }
  process_ = -1;
  if (problem == ENOENT) return Error{name_ + " is missing: apt-get install " + package};
  return Error{name_ + " cannot be run: " + std::strerror(problem)};
}

Child::~Child() {
  if (process_ >= 0) kill(process_, SIGKILL);
  wait();
  if (complaints_ != nullptr) std::fclose(complaints_);
}

bool Child::write(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t taken = ::write(input_, bytes.data(), bytes.size());
    if (taken < 0 && errno != EINTR) return false;
    if (taken > 0) bytes = bytes.subspan(static_cast<std::size_t>(taken));
  }
  return true;
}

/// Closes its input and gives its exit status; -1 if there is none to wait for.
int Child::wait() {
  if (input_ >= 0) close(std::exchange(input_, -1));
  int status = -1;
  const pid_t process = std::exchange(process_, -1);
  while (process >= 0 && waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  if (process >= 0) endOnInterrupt(-1);
  return status;
}

Status Child::end() {
  const int status = wait();
  if (status == 0) return Done{};
  const std::string complaint = firstComplaint();
  if (!complaint.empty()) return Error{name_ + ": " + complaint};
  if (WIFSIGNALED(status)) return Error{name_ + " was ended by signal " + std::to_string(WTERMSIG(status))};
  return Error{name_ + " failed with exit status " + std::to_string(WEXITSTATUS(status))};
}

std::string Child::firstComplaint() {
  char line[1024] = "";
  std::rewind(complaints_);
  if (std::fgets(line, sizeof line, complaints_) == nullptr) return "";
  return std::string(line, std::strcspn(line, "\r\n"));
}

}  // namespace brittle::program
