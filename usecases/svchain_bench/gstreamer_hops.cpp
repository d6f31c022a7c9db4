#include "usecases/svchain_bench/gstreamer_hops.h"

#include <cstring>
#include <future>
#include <gst/app/gstappsink.h>
#include <gst/app/gstappsrc.h>
#include <gst/gst.h>
#include <stdexcept>
#include <vector>

#include "ipc/message.h"
#include "usecases/svchain_bench/round_trips.h"

namespace svchain::bench {

namespace {

constexpr guint64 kWaiting = 64;  // buffers in the source and in the queue, as in our own rings

/// The consumer: called by the queue's thread for every buffer.
struct Arrivals {
  int expected;
  uint64_t next = 0;
  bool in_order = true;
  std::promise<void> all = {};

  void note(GstBuffer* buffer) {
    ipc::Message message;
    gst_buffer_extract(buffer, 0, &message, sizeof message);
    in_order = in_order && message.sequence == next;
    if (++next == static_cast<uint64_t>(expected)) all.set_value();
  }
};

GstFlowReturn take_sample(GstAppSink* sink, gpointer arrivals) {
  GstSample* const sample = gst_app_sink_pull_sample(sink);
  if (!sample) return GST_FLOW_EOS;
  static_cast<Arrivals*>(arrivals)->note(gst_sample_get_buffer(sample));
  gst_sample_unref(sample);
  return GST_FLOW_OK;
}

/// appsrc ! queue ! appsink, running as long as the object lives. Elements of the application come from their
/// library, so that no plug-in but GStreamer's core is needed.
class Pipeline {
 public:
  explicit Pipeline(Arrivals& arrivals) {
    gst_init(nullptr, nullptr);
    source_ = GST_APP_SRC(g_object_new(GST_TYPE_APP_SRC, "block", TRUE, "max-buffers", kWaiting, "max-bytes",
                                       guint64{0}, "emit-signals", FALSE, nullptr));
    GstElement* const queue = gst_element_factory_make("queue", nullptr);
    if (!queue) throw std::runtime_error("GStreamer has no queue");
    g_object_set(queue, "max-size-buffers", guint{kWaiting}, "max-size-bytes", guint{0}, "max-size-time",
                 guint64{0}, "silent", TRUE, nullptr);
    auto* const sink =
        GST_APP_SINK(g_object_new(GST_TYPE_APP_SINK, "sync", FALSE, "async", FALSE, "enable-last-sample",
                                  FALSE, "emit-signals", FALSE, nullptr));
    GstAppSinkCallbacks callbacks = {};
    callbacks.new_sample = take_sample;
    gst_app_sink_set_callbacks(sink, &callbacks, &arrivals, nullptr);
    pipeline_ = gst_pipeline_new(nullptr);
    gst_bin_add_many(GST_BIN(pipeline_), GST_ELEMENT(source_), queue, GST_ELEMENT(sink), nullptr);
    gst_element_link_many(GST_ELEMENT(source_), queue, GST_ELEMENT(sink), nullptr);
    if (gst_element_set_state(pipeline_, GST_STATE_PLAYING) == GST_STATE_CHANGE_FAILURE)
      throw std::runtime_error("GStreamer does not play");
    gst_element_get_state(pipeline_, nullptr, nullptr, GST_CLOCK_TIME_NONE);
  }
  ~Pipeline() {
    gst_element_set_state(pipeline_, GST_STATE_NULL);
    gst_object_unref(pipeline_);
  }
  Pipeline(const Pipeline&) = delete;
  Pipeline& operator=(const Pipeline&) = delete;

  /// Takes the buffer.
  void push(GstBuffer* buffer) {
    if (gst_app_src_push_buffer(source_, buffer) != GST_FLOW_OK)
      throw std::runtime_error("GStreamer takes no buffer");
  }

 private:
  GstElement* pipeline_;
  GstAppSrc* source_;  // the pipeline's
};

/// One for each message, made beforehand.
std::vector<GstBuffer*> buffers_of(int messages) {
  std::vector<GstBuffer*> buffers;
  ipc::Message message;
  for (int i = 0; i < messages; ++i) {
    message.sequence = static_cast<uint64_t>(i);
    buffers.push_back(gst_buffer_new_allocate(nullptr, sizeof message, nullptr));
    gst_buffer_fill(buffers.back(), 0, &message, sizeof message);
  }
  return buffers;
}

}  // namespace

std::string gstreamer_version() {
  return std::to_string(GST_VERSION_MAJOR) + "." + std::to_string(GST_VERSION_MINOR) + "." +
         std::to_string(GST_VERSION_MICRO);
}

double gstreamer_stream_ns(int messages) {
  Arrivals arrivals{messages};
  auto all = arrivals.all.get_future();
  Pipeline pipeline(arrivals);
  const std::vector<GstBuffer*> buffers = buffers_of(messages);
  const int64_t start_ns = now_ns();
  for (GstBuffer* const buffer : buffers) pipeline.push(buffer);
  all.wait();
  const int64_t end_ns = now_ns();
  if (!arrivals.in_order) throw std::runtime_error("GStreamer: a message is out of order");
  return static_cast<double>(end_ns - start_ns) / messages;
}

}  // namespace svchain::bench
