#pragma once
// The host's event loop while a chain runs: Ctrl-C and SIGTERM end it, SIGUSR1 has the geometry aligned anew;
// a line of progress on a terminal, and a watch over chains in which nothing moves any more.
//
// Attends one chain after the other, and lives longer than they do. attend() belongs to one thread; finish()
// any may call.

#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <future>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "framework/chain/chain.h"
#include "usecases/svchain/control_lines.h"

namespace svchain::program {

class HostLoop {
 public:
  /// From here on signals are ours: the first ends the run in good order, the second at once (status 130).
  HostLoop();

  /// Returns after finish(), or when a watched chain stands still for good: then the chain has a failure.
  /// `watched`: the chain runs on threads of its own, so that somebody has to notice when they all wait.
  /// `lossless`: a source that stays silent is a fault, and not just a camera that takes its time.
  void attend(Chain& chain, bool watched, bool lossless);
  void finish();
  /// From here on lines of that file, pipe or stdin ("-") are commands to links (control_lines.h), and what
  /// comes of them is logged. Before attend(). Throws std::runtime_error where it cannot be opened.
  void take_commands(const std::string& path);
  /// A signal has asked for the end, be it since the last chain. Not while attending.
  bool interrupted();

 private:
  /// A command on its way to a link.
  struct Question {
    ControlLine line;
    std::future<nlohmann::json> answer;
  };

  void await_end_signal();
  void await_recalibration_signal();
  void recalibrate();
  void ask(const ControlLine& line);
  void log_answers();
  void tick();
  void watch();
  void show_progress();

  boost::asio::io_context io_;
  boost::asio::signal_set end_signals_, recalibration_signal_;
  boost::asio::steady_timer timer_;
  Chain* chain_ = nullptr;
  int chains_ = 0;  // attended to their ends
  bool watched_ = false, lossless_ = false;
  bool ending_ = false;
  std::vector<Question> questions_;
  std::optional<ControlLines> lines_;
  bool progress_ = false;

  std::chrono::steady_clock::time_point started_at_;
  uint64_t calls_seen_ = 0;
  int quiet_ticks_ = 0;  // counted rather than timed: a program that was suspended has not stood still
};

}  // namespace svchain::program
