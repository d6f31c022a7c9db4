#include "tests/program/program.h"

#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <spawn.h>
#include <sstream>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/test_data.h"

extern char** environ;

namespace svchain::testing {

namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

pid_t spawn(const Arguments& arguments, const std::string& out, const std::string& err) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT | O_NOCTTY, 0600);
  std::vector<char*> argv = {const_cast<char*>(SVCHAIN_PROGRAM)};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  pid_t pid = 0;
  const int error = posix_spawn(&pid, SVCHAIN_PROGRAM, &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::runtime_error("the program could not be started");
  return pid;
}

int status_of(pid_t pid) {
  int status = 0;
  waitpid(pid, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

Outcome svchain_program(const Arguments& arguments) {
  const TemporaryFolder folder;
  const auto out = folder.path() / "out";
  const auto err = folder.path() / "err";
  const int status = status_of(spawn(arguments, out, err));
  return {status, text_of(out), text_of(err)};
}

Outcome svchain_interrupted(const Arguments& arguments, int signal,
                            const std::function<bool(const std::string&)>& reached) {
  return svchain_signalled(arguments, {{signal, reached}});
}

Outcome svchain_signalled(const Arguments& arguments, const std::vector<TimedSignal>& signals) {
  const TemporaryFolder folder;
  const auto out = folder.path() / "out";
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  grantpt(terminal);
  unlockpt(terminal);
  const pid_t pid = spawn(arguments, out, ptsname(terminal));
  std::string said;
  size_t sent = 0;
  char bytes[4096];
  for (ssize_t count = 0;
       (count = read(terminal, bytes, sizeof bytes)) > 0;) {  // fails when the other end is closed
    said.append(bytes, static_cast<size_t>(count));
    if (sent == signals.size() || !signals[sent].reached(said)) continue;
    kill(pid, signals[sent++].signal);
  }
  close(terminal);
  const int status = status_of(pid);
  return {status, text_of(out), said};
}

}  // namespace svchain::testing
