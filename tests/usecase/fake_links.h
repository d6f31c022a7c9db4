#pragma once
// Links that only describe themselves, named as the real ones, and a catalogue of them.

#include "framework/link/catalogue.h"

namespace svchain::testing {

class FakeLink : public Link {
 public:
  explicit FakeLink(LinkDescription description) : description_(std::move(description)) {}
  LinkDescription describe() const override { return description_; }
  void configure(Configuration&) override {}
  void process(Call&) override {}

 private:
  LinkDescription description_;
};

/// capture, sync, dup, geometric_alignment, synthesis, photometric_alignment, display, null, gain, join; the
/// settings view (with parts), rig (a file) and output (plain).
Catalogue fake_catalogue();

}  // namespace svchain::testing
