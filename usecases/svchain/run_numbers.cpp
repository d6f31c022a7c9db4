#include "usecases/svchain/run_numbers.h"

#include <charconv>

namespace svchain::program {

namespace {

/// A number from a command line, all of the text and within the range; nothing, and a fault, otherwise.
template <class Number>
std::optional<Number> read(const std::string& option, const std::optional<std::string>& text,
                           const char* kind, const json::Range& range, Faults& faults) {
  if (!text) return std::nullopt;
  Number value{};
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value);
  const bool whole = error == std::errc{} && end == text->data() + text->size();
  if (whole && range.contains(static_cast<double>(value))) return value;
  faults.push_back(
      {option, {}, {}, std::string("expected ") + kind + ", " + range.text() + ", got \"" + *text + "\""});
  return std::nullopt;
}

}  // namespace

std::optional<uint64_t> read_whole_number(const std::string& option, const std::optional<std::string>& text,
                                          const json::Range& range, Faults& faults) {
  return read<uint64_t>(option, text, "a whole number", range, faults);
}

std::optional<double> read_number(const std::string& option, const std::optional<std::string>& text,
                                  const json::Range& range, Faults& faults) {
  return read<double>(option, text, "a number", range, faults);
}

std::optional<double> read_fps(const std::optional<std::string>& text, Faults& faults) {
  return read_number("--fps", text, {0.01, 1000, "frames/s"}, faults);
}

RunNumbers read_numbers(const RunOptions& options, Faults& faults) {
  RunNumbers numbers;
  Pace& pace = numbers.pace;
  pace.frames = read_whole_number("--frames", options.frames, {1, 1e12}, faults);
  numbers.fps = read_fps(options.fps, faults);
  pace.real_time = numbers.fps.has_value();
  pace.fps = numbers.fps.value_or(pace.fps);
  numbers.seed = read_whole_number("--seed", options.seed, {0, 1.8e19}, faults);
  pace.virtual_clock = options.clock == "virtual";
  if (!pace.virtual_clock && options.clock != "steady") {
    faults.push_back({"--clock",
                      {},
                      {},
                      "expected steady or virtual, got \"" + options.clock + "\"" +
                          did_you_mean(options.clock, {"steady", "virtual"})});
  }
  pace.pixels = !options.no_pixels;
  if (!pace.pixels && !pace.virtual_clock) {
    faults.push_back(
        {"--no-pixels", {}, {}, "expected --clock virtual with it: only modelled time needs no pixels"});
  }
  if (options.use_case.costs && !pace.virtual_clock) {
    faults.push_back({"--costs", {}, {}, "expected --clock virtual with it: only modelled time has costs"});
  }
  return numbers;
}

}  // namespace svchain::program
