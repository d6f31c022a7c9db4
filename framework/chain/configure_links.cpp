#include <set>

#include "framework/chain/link_configuration.h"
#include "framework/chain/runtime.h"

namespace svchain {

namespace {

std::string port_name(const PlannedLink& link, const std::vector<PortDescription>& ports, int port) {
  return link.entry.name + "." + ports[static_cast<size_t>(port)].name;
}

/// Formats that the feedback edges bring, known only now that their producers are configured.
void check_feedback(const Plan& plan, const std::vector<LinkSetup>& setups, Faults& faults) {
  for (const PlannedEdge& edge : plan.edges) {
    if (!edge.entry.feedback) continue;
    const PlannedLink& from = plan.links[static_cast<size_t>(edge.from_link)];
    const PlannedLink& to = plan.links[static_cast<size_t>(edge.to_link)];
    const auto& format =
        setups[static_cast<size_t>(edge.from_link)].outputs[static_cast<size_t>(edge.from_port)];
    if (const auto m = mismatch(to.description.inputs[static_cast<size_t>(edge.to_port)], format)) {
      faults.push_back(edge.entry.origin.fault(
          "formats differ in " + m.field + ": \"" +
          port_name(from, from.description.outputs, edge.from_port) + "\" gives " + m.got + ", \"" +
          port_name(to, to.description.inputs, edge.to_port) + "\" takes " + m.expected));
    }
  }
}

/// Several links may have read the same faulty file.
Faults without_repeats(const Faults& faults) {
  Faults once;
  std::set<std::string> texts;
  for (const Fault& fault : faults) {
    if (texts.insert(fault.text()).second) once.push_back(fault);
  }
  return once;
}

}  // namespace

Result<std::vector<LinkSetup>> configure_links(Plan& plan, const Pace& pace) {
  std::vector<LinkSetup> setups(plan.links.size());
  std::vector<bool> sound(plan.links.size(), false);
  Faults faults;
  for (const int index : plan.source_to_sink) {
    PlannedLink& planned = plan.links[static_cast<size_t>(index)];
    std::vector<PortFormat> inputs(planned.description.inputs.size());
    std::vector<std::string> far_ends(inputs.size());
    bool upstream_sound = true;
    for (size_t port = 0; port < inputs.size(); ++port) {
      const int e = planned.input_edges[port];
      if (e < 0 || plan.edges[static_cast<size_t>(e)].entry.feedback) continue;
      const PlannedEdge& edge = plan.edges[static_cast<size_t>(e)];
      const auto from = static_cast<size_t>(edge.from_link);
      inputs[port] = setups[from].outputs[static_cast<size_t>(edge.from_port)];
      far_ends[port] = port_name(plan.links[from], plan.links[from].description.outputs, edge.from_port);
      upstream_sound = upstream_sound && sound[from];
    }
    std::vector<bool> connected;
    for (const int e : planned.output_edges) connected.push_back(e >= 0);
    LinkConfiguration configuration(planned.entry, planned.description, plan.use_case.settings, pace, inputs,
                                    far_ends, connected);
    if (!upstream_sound) {
      planned.link->check(configuration);
    } else if (configuration.found().empty()) {
      planned.link->configure(configuration);
    }
    faults.insert(faults.end(), configuration.found().begin(), configuration.found().end());
    sound[static_cast<size_t>(index)] = upstream_sound && configuration.found().empty();
    setups[static_cast<size_t>(index)] = {configuration.outputs(), configuration.held_frames(),
                                          configuration.preloaded_buffers(),
                                          configuration.wants_calls_without_room()};
  }
  if (faults.empty()) check_feedback(plan, setups, faults);
  if (!faults.empty()) return tl::unexpected(without_repeats(faults));
  return setups;
}

}  // namespace svchain
