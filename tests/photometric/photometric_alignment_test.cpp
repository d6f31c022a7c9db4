#include "algorithms/photometric/photometric_alignment.h"

#include <cstring>

#include "tests/catch.h"
#include "tests/photometric/made_statistics.h"
#include "tests/allocation_count.h"

using namespace svchain;
using namespace svchain::photometric;
using namespace svchain::testing;

namespace {

constexpr std::array<Response, 4> kEqual = {Response{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}};

}  // namespace

TEST_CASE("before the first frame every value stays as it is") {
  const auto identity = synthesis::ToneMapping::identity();
  CHECK(PhotometricAlignment(4, 0.1).tone_mapping().curves == identity.curves);
}

TEST_CASE("the first estimate is taken at once") {
  auto statistics = ring_of_four(kFourResponses);
  PhotometricAlignment alignment(4, 0.1);
  const auto& mapping = alignment.update(*statistics);
  CHECK(mapping.curves == tone_mapping(estimate_gains(*statistics, 4)).curves);
}

TEST_CASE("frames that tell nothing do not count as the first") {
  MadeStatistics nothing;
  auto statistics = ring_of_four(kFourResponses);
  PhotometricAlignment alignment(4, 0.1);
  alignment.update(*nothing);
  CHECK(alignment.update(*statistics).curves == tone_mapping(estimate_gains(*statistics, 4)).curves);
}

TEST_CASE("later changes are followed by their share per frame") {
  auto before = ring_of_four(kEqual), after = ring_of_four(kFourResponses);
  const Gains target = estimate_gains(*after, 4);
  PhotometricAlignment alignment(4, 0.25);
  alignment.update(*before);
  double left = 1;
  for (int frame = 0; frame < 10; ++frame) {
    alignment.update(*after);
    left *= 0.75;
    for (int i = 0; i < 4; ++i)
      CHECK(std::log(alignment.gains().value[i][0]) ==
            Approx((1 - left) * std::log(target.value[i][0])).margin(1e-5));
  }
}

TEST_CASE("a frame that tells nothing changes nothing") {
  auto statistics = ring_of_four(kFourResponses);
  MadeStatistics nothing;
  PhotometricAlignment alignment(4, 0.5);
  const auto mapping = alignment.update(*statistics);
  CHECK(alignment.update(*nothing).curves == mapping.curves);
  CHECK(alignment.gains().blocks_used == 0);
}

TEST_CASE("over many frames the common level does not drift") {
  PhotometricAlignment alignment(4, 0.3);
  auto day = ring_of_four(kEqual, 0.02), night = ring_of_four(kFourResponses, 0.02);
  for (int frame = 0; frame < 200; ++frame) alignment.update(frame % 2 ? *day : *night);
  double product = 1;
  for (int i = 0; i < 4; ++i) product *= alignment.gains().value[i][1];
  CHECK(product == Approx(1).epsilon(1e-6));
}

TEST_CASE("the same frames give the same tone mapping, bit by bit") {
  auto statistics = ring_of_four(kFourResponses, 0.05);
  PhotometricAlignment a(4, 0.1), b(4, 0.1);
  for (int frame = 0; frame < 5; ++frame) {
    a.update(*statistics);
    b.update(*statistics);
  }
  CHECK(std::memcmp(&a.gains().value, &b.gains().value, sizeof a.gains().value) == 0);
  CHECK(a.tone_mapping().curves == b.tone_mapping().curves);
}

TEST_CASE("an update allocates nothing") {
  auto statistics = ring_of_four(kFourResponses, 0.05);
  PhotometricAlignment alignment(4, 0.1);
  const size_t before = allocation_count();
  alignment.update(*statistics);
  CHECK(allocation_count() == before);
}

TEST_CASE("numbers of cameras and smoothings out of range are refused") {
  CHECK_THROWS_AS(PhotometricAlignment(0, 0.1), std::invalid_argument);
  CHECK_THROWS_AS(PhotometricAlignment(9, 0.1), std::invalid_argument);
  CHECK_THROWS_AS(PhotometricAlignment(4, 0), std::invalid_argument);
  CHECK_THROWS_AS(PhotometricAlignment(4, 1.5), std::invalid_argument);
}
