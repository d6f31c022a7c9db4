#include "links/photometric_alignment.h"

#include <cstring>
#include <optional>

#include "algorithms/photometric/photometric_alignment.h"
#include "framework/link/call.h"

namespace svchain {

namespace {

constexpr int kStatistics = 0;
constexpr int kToneMapping = 0;
constexpr size_t kCameraCount = 4;

class PhotometricAlignmentLink final : public Link {
 public:
  LinkDescription describe() const override {
    LinkDescription d;
    d.type = "photometric_alignment";
    d.help = "matches the cameras' brightness and colour: gains for all four jointly, from their overlaps";
    d.inputs = {
        {.name = "statistics", .types = {"overlap_statistics"}, .count = 1, .help = "of the last composite"}};
    d.outputs = {
        {.name = "tone_mapping", .types = {"tone_mapping"}, .count = 1, .help = "for the next composite"}};
    d.parameters = {number("smoothing", 0.2, {0.001, 1}, "",
                           "share of the way to a new estimate that is gone with every frame; 1: at once")};
    return d;
  }

  void configure(Configuration& configuration) override {
    configuration.output(kToneMapping, {Format::table("tone_mapping", sizeof(synthesis::ToneMapping))});
    alignment_.emplace(kCameraCount, configuration.parameters().number("smoothing"));
  }

  void process(Call& call) override {
    const auto* statistics =
        reinterpret_cast<const synthesis::OverlapStatistics*>(call.input(kStatistics).bytes().data());
    Draft curves = call.create(kToneMapping);
    std::memcpy(curves.bytes().data(), &alignment_->update(*statistics), sizeof(synthesis::ToneMapping));
    call.send(kToneMapping, std::move(curves));
  }

 private:
  std::optional<photometric::PhotometricAlignment> alignment_;
};

}  // namespace

std::unique_ptr<Link> make_photometric_alignment() {
  return std::make_unique<PhotometricAlignmentLink>();
}

}  // namespace svchain
