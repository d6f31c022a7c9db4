#include "links/select.h"

#include <cmath>
#include <vector>

#include "framework/link/call.h"
#include "ipc/message.h"

namespace svchain {

namespace {

class Select final : public Link {
 public:
  LinkDescription describe() const override {
    LinkDescription d;
    d.type = "select";
    d.help = "Hands on some of the buffers of a set";
    d.inputs = {{.name = "in", .help = "sets"}};
    d.outputs = {{.name = "out", .forwards = {"in"}, .help = "the chosen buffers"}};
    ParameterDescription buffers;
    buffers.name = "buffers";
    buffers.kind = Kind::kNumbers;
    buffers.fallback = nlohmann::json::array({0});
    buffers.range = {0, ipc::kMaxBuffers - 1};
    buffers.help = "which buffers of the set, counted from 0, in the order in which they go out";
    d.parameters = {buffers};
    return d;
  }

  void configure(Configuration& configuration) override {
    const PortFormat& set = configuration.input(0);
    const std::vector<double> wanted = configuration.parameters().numbers("buffers");
    if (wanted.empty() || wanted.size() > ipc::kMaxBuffers) {
      configuration.parameter_fault("buffers", "names " + std::to_string(wanted.size()) +
                                                   " buffers, expected 1 to " +
                                                   std::to_string(ipc::kMaxBuffers));
      return;
    }
    buffers_.clear();
    PortFormat chosen;
    for (const double buffer : wanted) {
      if (buffer != std::floor(buffer) || buffer < 0 || buffer >= static_cast<double>(set.size())) {
        configuration.parameter_fault("buffers", nlohmann::json(buffer).dump() +
                                                     " is no buffer of the set, expected 0 to " +
                                                     std::to_string(set.size() - 1));
        return;
      }
      buffers_.push_back(static_cast<int>(buffer));
      chosen.push_back(set[static_cast<size_t>(buffer)]);
    }
    configuration.output(0, chosen);
  }

  void process(Call& call) override {
    Frame chosen;
    for (const int buffer : buffers_) {
      if (call.input(0).has(buffer)) {
        chosen.append(call.input(0).part(buffer));
      } else {
        chosen.append_missing();
      }
    }
    if (!chosen.holder()) return call.drop("camera_missing");  // none of the chosen ones is there
    call.send(0, std::move(chosen));
  }

 private:
  std::vector<int> buffers_;
};

}  // namespace

std::unique_ptr<Link> make_select() {
  return std::make_unique<Select>();
}

}  // namespace svchain
