#include "links/null.h"

#include "framework/link/call.h"

namespace svchain {

namespace {

class Null final : public Link {
 public:
  LinkDescription describe() const override {
    LinkDescription d;
    d.type = "null";
    d.help = "Takes frames and does nothing with them";
    d.inputs = {{.name = "in", .help = "frames"}};
    return d;
  }
  void configure(Configuration&) override {}
  void process(Call&) override {}
};

}  // namespace

std::unique_ptr<Link> make_null() {
  return std::make_unique<Null>();
}

}  // namespace svchain
