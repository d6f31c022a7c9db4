#pragma once
// A link in another one's place, which goes through its life as that one would alone: for looking over a
// link's shoulder. Heirs say in process() what they look at. Owns the link; its rules are the link's.

#include <memory>
#include <utility>

#include "framework/link/link.h"

namespace svchain {

class WrappedLink : public Link {
 public:
  explicit WrappedLink(std::unique_ptr<Link> link) : link_(std::move(link)) {}

  LinkDescription describe() const override { return link_->describe(); }
  void configure(Configuration& configuration) override { link_->configure(configuration); }
  void check(Configuration& configuration) override { link_->check(configuration); }
  void start() override { link_->start(); }
  bool finish(Call& call) override { return link_->finish(call); }
  nlohmann::json control(const std::string& command, const nlohmann::json& arguments) override {
    return link_->control(command, arguments);
  }
  void stop() override { link_->stop(); }
  void report(nlohmann::json& report) const override { link_->report(report); }

 protected:
  Link& link() { return *link_; }

 private:
  std::unique_ptr<Link> link_;
};

}  // namespace svchain
