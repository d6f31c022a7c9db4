#pragma once
// What may be done with a chain, and when.
//
//              configure     start      drain      stop
//   created    configured    -          -          stopped
//   configured -             running    -          stopped
//   running    -             -          draining   stopped
//   draining   -             -          draining   stopped
//   stopped    configured    -          -          stopped

#include <optional>
#include <string>

namespace svchain {

enum class ChainState { kCreated, kConfigured, kRunning, kDraining, kStopped };
enum class ChainAction { kConfigure, kStart, kDrain, kStop };

/// The state after an action; nothing where the action is not allowed.
constexpr std::optional<ChainState> next_state(ChainState state, ChainAction action) {
  switch (action) {
    case ChainAction::kConfigure:
      if (state == ChainState::kCreated || state == ChainState::kStopped) return ChainState::kConfigured;
      return std::nullopt;
    case ChainAction::kStart:
      if (state == ChainState::kConfigured) return ChainState::kRunning;
      return std::nullopt;
    case ChainAction::kDrain:
      if (state == ChainState::kRunning || state == ChainState::kDraining) return ChainState::kDraining;
      return std::nullopt;
    case ChainAction::kStop:
      return ChainState::kStopped;
  }
  return std::nullopt;
}

constexpr const char* name_of(ChainState state) {
  constexpr const char* kNames[] = {"created", "configured", "running", "draining", "stopped"};
  return kNames[static_cast<int>(state)];
}

constexpr const char* name_of(ChainAction action) {
  constexpr const char* kNames[] = {"configure", "start", "drain", "stop"};
  return kNames[static_cast<int>(action)];
}

}  // namespace svchain
