#pragma once
// What a loop that spins does in between, so that it leaves the core's other thread and its own power alone.

namespace svchain::ipc {

inline void pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

}  // namespace svchain::ipc
