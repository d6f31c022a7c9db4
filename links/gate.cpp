#include "links/gate.h"

#include <stdexcept>

#include "framework/link/call.h"

namespace svchain {

namespace {

class Gate final : public Link {
 public:
  LinkDescription describe() const override {
    LinkDescription d;
    d.type = "gate";
    d.help = "Lets frames through, or drops them";
    d.inputs = {{.name = "in", .help = "frames"}};
    d.outputs = {{.name = "out", .forwards = {"in"}, .help = "the same frames while the gate is open"}};
    d.parameters = {boolean("open", true, "whether it is open at the start")};
    return d;
  }

  void configure(Configuration& configuration) override {
    open_ = configuration.parameters().flag("open");
    configuration.output(0, configuration.input(0));
  }

  void process(Call& call) override {
    if (!open_) return call.drop("gate_closed");
    call.send(0, call.take(0));
  }

  nlohmann::json control(const std::string& command, const nlohmann::json&) override {
    if (command != "open" && command != "close") {
      throw std::invalid_argument("no command \"" + command + "\", expected open or close");
    }
    open_ = command == "open";
    return {{"open", open_}};
  }

 private:
  bool open_ = true;
};

}  // namespace

std::unique_ptr<Link> make_gate() {
  return std::make_unique<Gate>();
}

}  // namespace svchain
