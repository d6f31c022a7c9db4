#include "usecases/svchain/host_loop.h"

#include <boost/asio/post.hpp>
#include <csignal>
#include <cstdio>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include "framework/chain/run.h"
#include "usecases/svchain/exit_status.h"

namespace svchain::program {

namespace {

using namespace std::chrono_literals;

constexpr auto kTick = 100ms;
constexpr int kLostFeedbackAfter = 2s / kTick;
constexpr int kStandstillAfter = 5s / kTick;

}  // namespace

HostLoop::HostLoop()
    : end_signals_(io_, SIGINT, SIGTERM),
      recalibration_signal_(io_, SIGUSR1),
      timer_(io_),
      progress_(isatty(STDERR_FILENO) == 1) {
  await_end_signal();
  await_recalibration_signal();
}

void HostLoop::await_end_signal() {
  end_signals_.async_wait([this](const boost::system::error_code& error, int) {
    if (error) return;
    if (ending_) _exit(kInterrupted);
    ending_ = true;
    spdlog::info("interrupted: what was captured is delivered, then the run ends (once more: at once)");
    await_end_signal();
  });
}

void HostLoop::await_recalibration_signal() {
  recalibration_signal_.async_wait([this](const boost::system::error_code& error, int) {
    if (error) return;
    if (chain_) recalibrate();
    await_recalibration_signal();
  });
}

/// Of every link that aligns the geometry.
void HostLoop::recalibrate() {
  for (const PlannedLink& link : chain_->plan().links)
    if (link.entry.type == "geometric_alignment") ask({link.entry.name, "recalibrate"});
}

void HostLoop::take_commands(const std::string& path) {
  lines_.emplace(io_, path, [this](const std::string& line) {
    try {
      if (chain_) ask(parse_control_line(line));
    } catch (const std::exception& error) {
      spdlog::warn("--control: {}", error.what());
    }
  });
}

void HostLoop::ask(const ControlLine& line) {
  try {
    questions_.push_back({line, chain_->control(line.link, line.command, line.arguments)});
  } catch (const std::exception& error) {  // the chain is ending
    spdlog::warn("{}: {} came too late: {}", line.link, line.command, error.what());
  }
}

void HostLoop::log_answers() {
  std::erase_if(questions_, [](Question& question) {
    if (question.answer.wait_for(0s) != std::future_status::ready) return false;
    const ControlLine& line = question.line;
    try {
      const nlohmann::json answer = question.answer.get();
      const auto said = answer.find(line.command);
      spdlog::info("{}: {}: {}", line.link, line.command,
                   said != answer.end() && said->is_string() ? said->get<std::string>() : answer.dump());
    } catch (const std::exception& error) {
      spdlog::warn("{}: {} refused: {}", line.link, line.command, error.what());
    }
    return true;
  });
}

void HostLoop::finish() {
  boost::asio::post(io_, [this] { io_.stop(); });
}

void HostLoop::attend(Chain& chain, bool watched, bool lossless) {
  chain_ = &chain;
  watched_ = watched;
  lossless_ = lossless;
  started_at_ = std::chrono::steady_clock::now();
  io_.restart();
  tick();
  io_.run();
  timer_.cancel();
  ++chains_;
  log_answers();
  questions_.clear();  // who has not been asked by now never will be
  chain_ = nullptr;
  if (progress_) std::fputs("\r\033[K", stderr);
}

bool HostLoop::interrupted() {
  io_.restart();
  io_.poll();
  return ending_;
}

void HostLoop::tick() {
  if (ending_)
    chain_->request_end();  // again and again: the first may have come before the chain was running
  log_answers();
  if (watched_) watch();
  if (progress_) show_progress();
  timer_.expires_after(kTick);
  // One that had expired already when it was cancelled comes all the same, when its chain is gone.
  timer_.async_wait([this, chain = chains_](const boost::system::error_code& error) {
    if (!error && chain == chains_) tick();
  });
}

void HostLoop::watch() {
  const uint64_t calls = chain_->calls();
  if (calls != calls_seen_ || chain_->busy() || chain_->finished()) {
    calls_seen_ = calls;
    quiet_ticks_ = 0;
    return;
  }
  ++quiet_ticks_;
  if (quiet_ticks_ == kLostFeedbackAfter && chain_->excuse_lost_feedback()) {
    spdlog::warn("a feedback message got lost: going on without it");
  }
  if (quiet_ticks_ < kStandstillAfter || !(lossless_ || ending_)) return;
  chain_->fail(stall_of(*chain_));
  io_.stop();
}

void HostLoop::show_progress() {
  const Progress progress = chain_->progress();
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - started_at_).count();
  const double fps = seconds > 0 ? static_cast<double>(progress.delivered) / seconds : 0.0;
  std::fprintf(stderr, "\r\033[K%llu frames, %.1f frames/s, %llu dropped",
               static_cast<unsigned long long>(progress.delivered), fps,
               static_cast<unsigned long long>(progress.dropped));
  std::fflush(stderr);
}

}  // namespace svchain::program
