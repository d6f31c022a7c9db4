#include "links/display/display.h"

#include <optional>

#include "framework/link/call.h"
#include "links/display/frame_writer.h"
#include "links/display/pixel_hash.h"
#include "links/picture_parameters.h"

namespace svchain {

namespace {

class Display final : public Link {
 public:
  LinkDescription describe() const override {
    LinkDescription d;
    d.type = "display";
    d.help = "Delivers frames to a file, a folder, a window, or nowhere";
    d.inputs = {
        {.name = "frames", .types = {"bgr8", "bgrx8", "nv12", "yuyv"}, .count = 1, .help = "pictures"}};
    d.parameters = {boolean("sha256", false, "hashes all delivered pixels for the report")};
    d.delivers = true;
    return d;
  }

  void configure(Configuration& configuration) override {
    check_colours(configuration, 0);
    output_ = configuration.setting("output").text("value");
    hash_.reset();
    writer_.reset();
    if (!configuration.pace().pixels) return;
    if (configuration.parameters().flag("sha256")) hash_.emplace();
    auto writer = make_writer(output_, {configuration.input(0).front(), configuration.pace().fps});
    if (!writer) return configuration.faults(writer.error());
    writer_ = std::move(*writer);
    if (writer_) configuration.holds(0, writer_->holds());
  }

  void check(Configuration& configuration) override {
    const std::string output = configuration.setting("output").text("value");
    const Format any_size = Format::bgr8(64, 64);  // serves to find the faults of the path
    const auto writer = make_writer(output, {any_size, configuration.pace().fps});
    if (!writer) configuration.faults(writer.error());
  }

  void process(Call& call) override {
    if (hash_) hash_->add(shown_.of(call.input(0)));
    if (!writer_) return;
    try {
      writer_->write(call.take(0), shown_);
    } catch (...) {
      writer_.reset();  // with what it has begun
      throw;
    }
  }

  void stop() override {
    const std::unique_ptr<FrameWriter> writer = std::move(writer_);
    if (writer) writer->finish();
  }

  void report(nlohmann::json& report) const override {
    if (hash_) report["output"]["sha256"] = hash_->text();
    if (output_ != "none") report["output"]["path"] = output_;
  }

 private:
  std::string output_;
  std::unique_ptr<FrameWriter> writer_;
  std::optional<PixelHash> hash_;
  ShownFrame shown_;
};

}  // namespace

std::unique_ptr<Link> make_display() {
  return std::make_unique<Display>();
}

}  // namespace svchain
