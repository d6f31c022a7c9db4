#include "framework/chain/link_configuration.h"

#include <algorithm>

namespace svchain {

LinkConfiguration::LinkConfiguration(const LinkEntry& entry, const LinkDescription& description,
                                     const std::map<std::string, Parameters>& settings, const Pace& pace,
                                     std::vector<PortFormat> inputs, std::vector<std::string> far_ends,
                                     std::vector<bool> outputs_connected)
    : entry_(entry),
      description_(description),
      settings_(settings),
      pace_(pace),
      inputs_(std::move(inputs)),
      far_ends_(std::move(far_ends)),
      outputs_connected_(std::move(outputs_connected)),
      outputs_(description.outputs.size()),
      holds_(description.inputs.size()),
      preloaded_(description.outputs.size()) {
  for (size_t i = 0; i < description_.inputs.size(); ++i) {
    if (inputs_[i].empty()) continue;
    if (const auto m = mismatch(description_.inputs[i], inputs_[i])) {
      format_fault(static_cast<int>(i), m.field, m.expected, m.got);
    }
  }
}

void LinkConfiguration::fault(std::string what) {
  faults_.push_back(entry_.origin.fault(std::move(what)));
}

void LinkConfiguration::parameter_fault(const std::string& parameter, std::string what) {
  const auto it = entry_.parameter_origins.find(parameter);
  if (it != entry_.parameter_origins.end()) {
    faults_.push_back(it->second.fault(std::move(what)));
  } else {
    fault("parameter \"" + parameter + "\": " + what);
  }
}

void LinkConfiguration::format_fault(int input_port, std::string field, std::string expected,
                                     std::string got) {
  const auto port = static_cast<size_t>(input_port);
  fault("formats differ in " + field + ": \"" + far_ends_[port] + "\" gives " + got + ", \"" + entry_.name +
        "." + description_.inputs[port].name + "\" takes " + expected);
}

FormatMismatch mismatch(const PortDescription& port, const PortFormat& format) {
  if (port.count > 0 && port.count != static_cast<int>(format.size())) {
    return {"buffers", std::to_string(port.count), std::to_string(format.size())};
  }
  if (port.types.empty()) return {};
  for (const Format& buffer : format) {
    if (std::find(port.types.begin(), port.types.end(), buffer.type) == port.types.end()) {
      return {"type", spoken_list(port.types), buffer.type};
    }
  }
  return {};
}

}  // namespace svchain
