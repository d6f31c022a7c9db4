#pragma once
// A link with somebody looking over its shoulder: goes through its life as the link would alone, and keeps
// copies of what it was given last. For looking at a run after its end, when all buffers have gone back.
//
// Takes the link's place in a plan. Belongs to the link's core while the chain runs, to the controlling
// thread afterwards.

#include <memory>
#include <vector>

#include "framework/link/link.h"

namespace svchain::program {

class KeptInputs final : public Link {
 public:
  struct Buffer {
    Format format;
    std::vector<std::byte> bytes;
  };
  /// Empty where nothing ever came.
  using Set = std::vector<Buffer>;

  explicit KeptInputs(std::unique_ptr<Link> link);

  /// The newest there was at an input.
  const Set& last(const std::string& port) const;

  LinkDescription describe() const override { return link_->describe(); }
  void configure(Configuration& configuration) override { link_->configure(configuration); }
  void check(Configuration& configuration) override { link_->check(configuration); }
  void start() override { link_->start(); }
  void process(Call& call) override;
  bool finish(Call& call) override { return link_->finish(call); }
  nlohmann::json control(const std::string& command, const nlohmann::json& arguments) override {
    return link_->control(command, arguments);
  }
  void stop() override { link_->stop(); }
  void report(nlohmann::json& report) const override { link_->report(report); }

 private:
  std::unique_ptr<Link> link_;
  std::vector<std::string> ports_;
  std::vector<Set> last_;  // by input port
};

}  // namespace svchain::program
