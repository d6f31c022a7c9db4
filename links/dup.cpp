#include "links/dup.h"

#include <vector>

#include "framework/link/call.h"

namespace svchain {

namespace {

constexpr int kOutputs = 6;

class Dup final : public Link {
 public:
  LinkDescription describe() const override {
    LinkDescription d;
    d.type = "dup";
    d.help = "Hands the same frames to several links";
    d.inputs = {{.name = "in", .help = "frames"}};
    for (int i = 0; i < kOutputs; ++i) {
      d.outputs.push_back({.name = "out" + std::to_string(i), .forwards = {"in"}, .help = "the same frames"});
    }
    return d;
  }

  void configure(Configuration& configuration) override {
    ports_.clear();
    for (int port = 0; port < kOutputs; ++port) {
      configuration.output(port, configuration.input(0));
      if (configuration.output_connected(port)) ports_.push_back(port);
    }
  }

  void process(Call& call) override {
    for (const int port : ports_) call.send(port, call.input(0).share());
  }

 private:
  std::vector<int> ports_;  // connected ones
};

}  // namespace

std::unique_ptr<Link> make_dup() {
  return std::make_unique<Dup>();
}

}  // namespace svchain
