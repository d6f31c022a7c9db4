#pragma once
// A link with somebody looking over its shoulder, who holds what it was given last and copies it when the
// link stops. For looking at a run after its end, when all buffers have gone back.
//
// Takes the link's place in a plan. Belongs to the link's core while the chain runs, to the controlling
// thread afterwards.

#include <memory>
#include <vector>

#include "framework/buffer/frame.h"
#include "framework/link/wrapped_link.h"

namespace svchain::program {

class KeptInputs final : public WrappedLink {
 public:
  struct Buffer {
    Format format;
    std::vector<std::byte> bytes;
  };
  /// Empty where nothing ever came.
  using Set = std::vector<Buffer>;

  explicit KeptInputs(std::unique_ptr<Link> link);

  /// The newest there was at an input, once the chain has stopped.
  const Set& last(const std::string& port) const;

  void configure(Configuration& configuration) override;
  void process(Call& call) override;
  void stop() override;

 private:
  std::vector<std::string> ports_;
  std::vector<Frame> held_;  // by input port
  std::vector<Set> last_;
};

}  // namespace svchain::program
