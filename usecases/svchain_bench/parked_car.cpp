#include <cstdlib>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

#include "algorithms/scene/renderer.h"
#include "algorithms/scene/scene_file.h"
#include "links/configs_folder.h"
#include "usecases/svchain_bench/faults.h"
#include "usecases/svchain_bench/surround_view.h"

namespace svchain::bench {

namespace {

namespace fs = std::filesystem;

fs::path temporary_folder() {
  std::string name = (fs::temp_directory_path() / "svchain_bench.XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error(name + ": no such folder can be made");
  return name;
}

}  // namespace

ParkedCar::ParkedCar() : folder_(temporary_folder()) {
  auto scene = value_or_throw(scene::read_scene(configs_folder() / "scenes" / "parking.json"));
  rig_ = scene.rig;
  const scene::Renderer renderer(std::make_shared<const scene::World>(std::move(scene)));
  for (size_t camera = 0; camera < pictures_.size(); ++camera) {
    renderer.render(camera, 0, 0, pictures_[camera]);
    cv::imwrite((folder_ / (rig_.cameras[camera].name + ".png")).string(), pictures_[camera]);
  }
  std::ofstream(rig_file()) << geometry::rig_text(rig_);
}

ParkedCar::~ParkedCar() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

}  // namespace svchain::bench
