#include "algorithms/scene/solids_json.h"

#include "algorithms/scene/paint_json.h"

namespace svchain::scene {

namespace {

const json::Range kLength{1e-4, 1e3};

}  // namespace

std::vector<Box> read_boxes(const json::Value& list) {
  std::vector<Box> boxes;
  for (const auto& item : list.items()) {
    item.only({"pose", "size_m", "colour_bgr"});
    const Pose2 pose = read_pose(item.required("pose"));
    const auto size = item.required("size_m").numbers(3, kLength);
    boxes.push_back({pose, {size[0], size[1], size[2]}, read_colour(item.required("colour_bgr"), {})});
  }
  return boxes;
}

std::vector<Post> read_posts(const json::Value& list) {
  std::vector<Post> posts;
  for (const auto& item : list.items()) {
    item.only({"place_m", "radius_m", "height_m", "colour_bgr"});
    const auto place = item.required("place_m").numbers(2, {-1e3, 1e3});
    posts.push_back({{place[0], place[1]},
                     item.required("radius_m").number(kLength),
                     item.required("height_m").number(kLength),
                     read_colour(item.required("colour_bgr"), {})});
  }
  return posts;
}

}  // namespace svchain::scene
