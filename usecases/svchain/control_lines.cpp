#include "usecases/svchain/control_lines.h"

#include <boost/asio/post.hpp>
#include <boost/asio/read_until.hpp>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <istream>
#include <sstream>
#include <stdexcept>
#include <sys/stat.h>
#include <unistd.h>

#include "algorithms/json/document.h"

namespace svchain::program {

namespace {

constexpr size_t kLongestLine = 1 << 16;

/// A named pipe is opened for writing too, so that it does not end with its first writer.
int opened(const std::string& path) {
  struct stat status {};
  const bool pipe = stat(path.c_str(), &status) == 0 && S_ISFIFO(status.st_mode);
  const int file =
      path == "-" ? dup(STDIN_FILENO) : open(path.c_str(), (pipe ? O_RDWR : O_RDONLY) | O_CLOEXEC);
  if (file < 0) throw std::runtime_error(path + ": cannot be read: " + std::strerror(errno));
  return file;
}

bool is_plain_file(int file) {
  struct stat status {};
  return fstat(file, &status) == 0 && S_ISREG(status.st_mode);
}

/// All of a plain file, for which nobody can wait.
std::string content_of(int file) {
  std::string text;
  char part[4096];
  for (ssize_t got; (got = read(file, part, sizeof(part))) > 0;) text.append(part, static_cast<size_t>(got));
  return text;
}

}  // namespace

ControlLine parse_control_line(const std::string& line) {
  std::istringstream words(line);
  ControlLine parsed;
  std::string arguments;
  words >> parsed.link >> parsed.command;
  std::getline(words, arguments);
  if (parsed.command.empty())
    throw std::invalid_argument("expected LINK COMMAND [JSON], got \"" + line + "\"");
  if (arguments.find_first_not_of(" \t\r") == std::string::npos) return parsed;
  const auto document = json::Document::parse(arguments, {});
  if (!document) throw std::invalid_argument(parsed.command + ": " + document.error().front().message);
  parsed.arguments = document->root();
  if (!parsed.arguments.is_object())
    throw std::invalid_argument(parsed.command + ": expected an object {...}, got " + arguments);
  return parsed;
}

ControlLines::ControlLines(boost::asio::io_context& io, const std::string& path, Handler handler)
    : input_(io), text_(kLongestLine), handler_(std::move(handler)) {
  const int file = opened(path);
  if (!is_plain_file(file)) {
    input_.assign(file);
    read_next();
    return;
  }
  std::istringstream lines(content_of(file));
  close(file);
  for (std::string line; std::getline(lines, line);) boost::asio::post(io, [this, line] { take(line); });
}

void ControlLines::read_next() {
  boost::asio::async_read_until(input_, text_, '\n', [this](const boost::system::error_code& error, size_t) {
    std::string line;
    std::getline(std::istream(&text_), line);
    take(line);
    if (!error) read_next();
  });
}

void ControlLines::take(const std::string& line) const {
  const auto begin = line.find_first_not_of(" \t\r");
  if (begin != std::string::npos && line[begin] != '#') handler_(line);
}

}  // namespace svchain::program
