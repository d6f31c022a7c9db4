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

HostLoop::HostLoop() : signals_(io_, SIGINT, SIGTERM), timer_(io_), progress_(isatty(STDERR_FILENO) == 1) {
  await_signal();
}

void HostLoop::await_signal() {
  signals_.async_wait([this](const boost::system::error_code& error, int) {
    if (error) return;
    if (ending_) _exit(kInterrupted);
    ending_ = true;
    spdlog::info("interrupted: what was captured is delivered, then the run ends (once more: at once)");
    await_signal();
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
  tick();
  io_.run();
  if (progress_) std::fputs("\r\033[K", stderr);
}

void HostLoop::tick() {
  if (ending_)
    chain_->request_end();  // again and again: the first may have come before the chain was running
  if (watched_) watch();
  if (progress_) show_progress();
  timer_.expires_after(kTick);
  timer_.async_wait([this](const boost::system::error_code& error) {
    if (!error) tick();
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
