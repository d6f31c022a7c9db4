#include "framework/buffer/attention.h"
#include "framework/buffer/frame.h"
#include "framework/buffer/holder.h"
#include "tests/catch.h"

using namespace svchain;

namespace {

struct Fixture {
  Fixture() {
    for (uint16_t id = 0; id < 2; ++id) {
      pools.push_back(std::make_unique<Pool>(id, "p", Format::bgr8(4, 2), 3, 2, PoolOwner{0, &attention, 0}));
    }
  }
  Frame take(size_t pool, int64_t timestamp_ns = 0) {
    ipc::Message m;
    m.count = 1;
    m.buffers[0] = {static_cast<uint16_t>(pool), *pools[pool]->take()};
    m.timestamp_ns[0] = timestamp_ns;
    return Frame(m, holder);
  }
  Attention attention{1};
  PoolTable pools;
  ReturnPath returns{0};
  Holder holder{0, pools, returns};
};

}  // namespace

TEST_CASE("a buffer goes home with its last handle and not before") {
  Fixture f;
  Frame a = f.take(0);
  Frame b = a.share();
  CHECK(f.pools[0]->held_by(0) == 1);
  a.release();
  CHECK(f.pools[0]->free() == 2);
  b = Frame();
  CHECK(f.pools[0]->free() == 3);
  CHECK(f.pools[0]->held_by(0) == 0);
}

TEST_CASE("a set carries its members in order and a missing one keeps its place") {
  Fixture f;
  Frame set;
  set.append_missing();
  Frame first = f.take(0, 10);
  first.set_sequence(7);
  set.append(std::move(first));
  set.append(f.take(1, 11));
  REQUIRE(set.count() == 3);
  CHECK(set.sequence() == 7);
  CHECK_FALSE(set.has(0));
  CHECK(set.has(1));
  CHECK(set.timestamp_ns(1) == 10);
  CHECK(set.timestamp_ns(2) == 11);
  Frame part = set.part(2);
  set.release();
  CHECK(f.pools[0]->free() == 3);
  CHECK(f.pools[1]->free() == 2);
  CHECK(part.timestamp_ns() == 11);
  CHECK(part.format().width_px == 4);
}

TEST_CASE("an empty pool yields nothing, and the most recently returned buffer comes first") {
  Fixture f;
  Frame a = f.take(0), b = f.take(0), c = f.take(0);
  CHECK_FALSE(f.pools[0]->take());
  CHECK(f.pools[0]->high_water() == 3);
  const auto* where = b.bytes().data();
  a.release();
  b.release();
  Frame again = f.take(0);
  CHECK(again.bytes().data() == where);
}

TEST_CASE("rows of a picture in a pool begin on cache lines") {
  Fixture f;
  Frame a = f.take(0);
  CHECK(a.format().pitch_bytes % 64 == 0);
  CHECK(reinterpret_cast<uintptr_t>(a.bytes().data()) % 64 == 0);
}
