#include "usecases/svchain/kept_inputs.h"

#include <algorithm>
#include <stdexcept>

#include "framework/link/call.h"

namespace svchain::program {

namespace {

/// A frame that a camera did not give keeps its place, empty.
void copy(const Frame& frame, KeptInputs::Set& set) {
  set.resize(static_cast<size_t>(frame.count()));
  for (int i = 0; i < frame.count(); ++i) {
    KeptInputs::Buffer& buffer = set[static_cast<size_t>(i)];
    buffer.bytes.clear();
    if (!frame.has(i)) continue;
    buffer.format = frame.format(i);
    buffer.bytes.assign(frame.bytes(i).begin(), frame.bytes(i).end());
  }
}

}  // namespace

KeptInputs::KeptInputs(std::unique_ptr<Link> wrapped) : WrappedLink(std::move(wrapped)) {
  for (const auto& port : link().describe().inputs) ports_.push_back(port.name);
  held_.resize(ports_.size());
  last_.resize(ports_.size());
}

const KeptInputs::Set& KeptInputs::last(const std::string& port) const {
  const auto found = std::find(ports_.begin(), ports_.end(), port);
  if (found == ports_.end()) throw std::logic_error("no input \"" + port + "\"");
  return last_[static_cast<size_t>(found - ports_.begin())];
}

/// A link that keeps a frame itself keeps the one that is held here.
void KeptInputs::configure(Configuration& configuration) {
  WrappedLink::configure(configuration);
  for (size_t port = 0; port < ports_.size(); ++port) configuration.holds(static_cast<int>(port), 1);
}

void KeptInputs::process(Call& call) {
  for (size_t port = 0; port < ports_.size(); ++port) {
    if (const Frame& frame = call.input(static_cast<int>(port))) held_[port] = frame.share();
  }
  link().process(call);
}

void KeptInputs::stop() {
  WrappedLink::stop();
  for (size_t port = 0; port < ports_.size(); ++port) {
    if (held_[port]) copy(held_[port], last_[port]);
    held_[port].release();
  }
}

}  // namespace svchain::program
