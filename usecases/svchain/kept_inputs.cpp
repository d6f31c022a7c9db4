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

KeptInputs::KeptInputs(std::unique_ptr<Link> link) : link_(std::move(link)) {
  for (const auto& port : link_->describe().inputs) ports_.push_back(port.name);
  last_.resize(ports_.size());
}

const KeptInputs::Set& KeptInputs::last(const std::string& port) const {
  const auto found = std::find(ports_.begin(), ports_.end(), port);
  if (found == ports_.end()) throw std::logic_error("no input \"" + port + "\"");
  return last_[static_cast<size_t>(found - ports_.begin())];
}

void KeptInputs::process(Call& call) {
  for (size_t port = 0; port < ports_.size(); ++port) {
    if (const Frame& frame = call.input(static_cast<int>(port))) copy(frame, last_[port]);
  }
  link_->process(call);
}

}  // namespace svchain::program
