#include "framework/link/plugin.h"

namespace {

class Brighten : public svchain::Link {
 public:
  svchain::LinkDescription describe() const override {
    svchain::LinkDescription d;
    d.type = "brighten";
    d.help = "adds a little";
    d.parameters = {svchain::integer("by", 10, {0, 255}, "", "how much")};
    return d;
  }
  void configure(svchain::Configuration&) override {}
  void process(svchain::Call&) override {}
};

}  // namespace

SVCHAIN_PLUGIN(Brighten)
