#include "framework/fault/fault_site.h"

namespace svchain {

double chance_of(uint64_t seed, uint64_t occasion) {
  uint64_t z = seed + 0x9e3779b97f4a7c15u * (occasion + 1);  // the finaliser of splitmix64
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  z ^= z >> 31;
  return static_cast<double>(z >> 11) * 0x1p-53;
}

const PlannedFault* FaultSite::strike(FaultKind kind, uint64_t occasion) {
  InjectedFault* fault = newest(kind);
  if (!fault) return nullptr;
  const PlannedFault& planned = *fault->planned;
  if (planned.chance < 1 && chance_of(fault->seed, occasion) >= planned.chance) return nullptr;
  fault->times.add();
  return &planned;
}

}  // namespace svchain
