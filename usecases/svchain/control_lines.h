#pragma once
// Commands to running links as lines of text, "LINK COMMAND [JSON]", from stdin, a named pipe or a file:
//
//   bowl_view viewpoint {"viewpoint": "left"}
//   geometric_alignment recalibrate
//
// Belongs to the thread of its event loop. Empty lines and those that begin with # are passed over.

#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/streambuf.hpp>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

namespace svchain::program {

struct ControlLine {
  std::string link, command;
  nlohmann::json arguments = nlohmann::json::object();
};

/// Throws std::invalid_argument that says what is wrong with the line.
ControlLine parse_control_line(const std::string& line);

class ControlLines {
 public:
  using Handler = std::function<void(const std::string& line)>;

  /// `path`: "-" for stdin. Throws std::runtime_error, naming it, where it cannot be opened. Lines come while
  /// the loop runs.
  ControlLines(boost::asio::io_context& io, const std::string& path, Handler handler);

 private:
  void read_next();
  void take(const std::string& line) const;

  boost::asio::posix::stream_descriptor input_;
  boost::asio::streambuf text_;
  Handler handler_;
};

}  // namespace svchain::program
