#pragma once
// The Configuration that a link sees, filled from a plan: collects what the link says of its outputs, and its
// faults with their places. One per link; used while configuring only.

#include <map>
#include <string>
#include <vector>

#include "framework/link/link.h"
#include "framework/usecase/plan.h"

namespace svchain {

class LinkConfiguration final : public Configuration {
 public:
  /// `inputs`: formats by port, empty where there is none. `names`: how messages call the far ends of the
  /// inputs.
  LinkConfiguration(const LinkEntry& entry, const LinkDescription& description,
                    const std::map<std::string, Parameters>& settings, const Pace& pace,
                    std::vector<PortFormat> inputs, std::vector<std::string> far_ends,
                    std::vector<bool> outputs_connected);

  const std::string& link_name() const override { return entry_.name; }
  const Parameters& parameters() const override { return entry_.parameters; }
  const Parameters& setting(const std::string& name) const override { return settings_.at(name); }
  const Pace& pace() const override { return pace_; }
  const PortFormat& input(int port) const override { return inputs_[static_cast<size_t>(port)]; }
  bool output_connected(int port) const override { return outputs_connected_[static_cast<size_t>(port)]; }

  void output(int port, PortFormat format) override {
    outputs_[static_cast<size_t>(port)] = std::move(format);
  }
  void holds(int input_port, int frames) override { holds_[static_cast<size_t>(input_port)] = frames; }
  void preloaded(int output_port, int buffers) override {
    preloaded_[static_cast<size_t>(output_port)] = buffers;
  }
  void calls_without_room() override { calls_without_room_ = true; }

  void fault(std::string what) override;
  void parameter_fault(const std::string& parameter, std::string what) override;
  void format_fault(int input_port, std::string field, std::string expected, std::string got) override;
  void faults(const Faults& found) override { faults_.insert(faults_.end(), found.begin(), found.end()); }

  const std::vector<PortFormat>& outputs() const { return outputs_; }
  const std::vector<int>& held_frames() const { return holds_; }
  const std::vector<int>& preloaded_buffers() const { return preloaded_; }
  bool wants_calls_without_room() const { return calls_without_room_; }
  const Faults& found() const { return faults_; }

 private:
  const LinkEntry& entry_;
  const LinkDescription& description_;
  const std::map<std::string, Parameters>& settings_;
  Pace pace_;
  std::vector<PortFormat> inputs_;
  std::vector<std::string> far_ends_;
  std::vector<bool> outputs_connected_;
  std::vector<PortFormat> outputs_;
  std::vector<int> holds_, preloaded_;
  bool calls_without_room_ = false;
  Faults faults_;
};

/// The first difference between a format and what a port takes, as field, expected, got; empty strings if it
/// fits.
struct FormatMismatch {
  std::string field, expected, got;
  explicit operator bool() const { return !field.empty(); }
};
FormatMismatch mismatch(const PortDescription& port, const PortFormat& format);

}  // namespace svchain
