#include "algorithms/synthesis/prefetch.h"

#include <algorithm>

namespace svchain::synthesis {
namespace {

using colour::Picture;
using colour::PixelFormat;

constexpr uintptr_t kCacheLine = 64;
enum Purpose { kToRead, kToWrite };

/// Most rows take three lines or fewer: those come without a branch that the processor could mistake.
template <Purpose kPurpose>
void ask(const uint8_t* begin, size_t count) {
  constexpr int kSecondLevel = 2;
  const uint8_t* const last = begin + count - 1;
  __builtin_prefetch(begin, kPurpose, kSecondLevel);
  __builtin_prefetch(std::min(begin + kCacheLine, last), kPurpose, kSecondLevel);
  __builtin_prefetch(last, kPurpose, kSecondLevel);
  for (const uint8_t* line = begin + 2 * kCacheLine; line < last; line += kCacheLine)
    __builtin_prefetch(line, kPurpose, kSecondLevel);
}

}  // namespace

void Prefetch::begin(const LutBlock* block, size_t work) {
  block_ = block;
  work_ = work;
  lines_ = block ? block->row_count + block->height : 0;
  done_ = asked_ = 0;
}

void Prefetch::advance(size_t work) {
  done_ = std::min(done_ + work, work_);
  ask_until(lines_ * done_ / std::max<size_t>(work_, 1));
}

void Prefetch::finish() {
  ask_until(lines_);
}

void Prefetch::ask_until(size_t line) {
  if (asked_ >= line) return;
  size_t begin = 0;  // of a source's lines
  const LutRow* const rows = lut_.rows(*block_).data();
  for (uint32_t i = 0; i < block_->source_count && begin < block_->row_count; ++i) {
    const size_t end = begin + block_->sources[i].height;
    const size_t from = std::max(asked_, begin), to = std::min(line, end);
    if (from < to) ask_source(block_->sources[i], rows + begin, from - begin, to - begin);
    begin = end;
  }
  if (line > begin) ask_target(std::max(asked_, begin) - begin, line - begin);
  asked_ = line;
}

void Prefetch::ask_source(const LutSource& source, const LutRow* rows, size_t begin, size_t end) const {
  const Picture& frame = frames_[source.camera];
  if (frame.empty()) return;
  const size_t pixel = bytes_per_px(frame.format);
  for (size_t i = begin; i < end; ++i) {
    if (rows[i].count == 0) continue;
    const size_t y = source.y + i, x = size_t{source.x} + rows[i].start;
    ask<kToRead>(frame.pixels + y * frame.pitch_bytes + x * pixel, rows[i].count * pixel);
    if (frame.format == PixelFormat::kNv12 && y % 2 == 0)
      ask<kToRead>(frame.chroma + y / 2 * frame.pitch_bytes + x / 2 * 2, size_t{rows[i].count} + 1);
  }
}

void Prefetch::ask_target(size_t begin, size_t end) const {
  const size_t pixel = bytes_per_px(out_.format);
  for (size_t i = begin; i < end; ++i) {
    const size_t y = block_->y + i;
    ask<kToWrite>(out_.pixels + y * out_.pitch_bytes + block_->x * pixel, block_->width * pixel);
    if (out_.format == PixelFormat::kNv12 && y % 2 == 0)
      ask<kToWrite>(out_.chroma + y / 2 * out_.pitch_bytes + block_->x, block_->width);
  }
}

}  // namespace svchain::synthesis
