#include "links/builtin_links.h"

#include "links/bowl/bowl_settings.h"
#include "links/bowl/bowl_view.h"
#include "links/bowl/bowl_view_gl.h"
#include "links/bowl/mesh_table.h"
#include "links/capture/capture.h"
#include "links/display/display.h"
#include "links/dup.h"
#include "links/gate.h"
#include "links/geometric_alignment/geometric_alignment.h"
#include "links/merge.h"
#include "links/mosaic.h"
#include "links/null.h"
#include "links/null_source.h"
#include "links/overlap_sampling.h"
#include "links/photometric_alignment.h"
#include "links/select.h"
#include "links/sync/sync.h"
#include "links/synthesis.h"

namespace svchain {

namespace {

ParameterDescription numbers(std::string name, nlohmann::json fallback, json::Range range, std::string unit,
                             std::string help) {
  ParameterDescription d = number(std::move(name), 0, range, std::move(unit), std::move(help));
  d.kind = Kind::kNumbers;
  d.count = 2;
  d.fallback = std::move(fallback);
  return d;
}

SettingDescription view_setting() {
  ParameterDescription scale =
      number("metres_per_px", 0, {1e-5, 1}, "m",
             "scale; left out: the vehicle's length takes 45 % of the view's height");
  scale.fallback = nullptr;
  return {
      "view",
      "the composite seen from above, forward is up",
      {numbers("size_px", {880, 1080}, {16, 8192}, "px", "width and height"), scale,
       numbers("centre_m", {0, 0}, {-100, 100}, "m", "ground point in the middle, in the vehicle's frame")}};
}

}  // namespace

void add_builtin_links(Catalogue& catalogue) {
  catalogue.add(make_bowl_view);
  catalogue.add(make_bowl_view_gl);
  catalogue.add(make_capture);
  catalogue.add(make_display);
  catalogue.add(make_dup);
  catalogue.add(make_gate);
  catalogue.add(make_geometric_alignment);
  catalogue.add(make_merge);
  catalogue.add(make_mesh_table);
  catalogue.add(make_mosaic);
  catalogue.add(make_null);
  catalogue.add(make_null_source);
  catalogue.add(make_overlap_sampling);
  catalogue.add(make_photometric_alignment);
  catalogue.add(make_select);
  catalogue.add(make_sync);
  catalogue.add(make_synthesis);

  catalogue.add(view_setting());
  catalogue.add(bowl_setting());
  catalogue.add(car_setting());
  catalogue.add(
      {"rig", "rig file of the cameras; left out: the simulated scene's own", {path("value", "rig file")}});
  catalogue.add(
      {"input",
       "where frames come from",
       {text("value", "simulated:parking", "a folder, simulated:SCENE, or front=URL,right=URL,...")}});
  catalogue.add({"output",
                 "where the composite goes",
                 {text("value", "none", ".png, .mp4, .mkv, a folder, window or none")}});
}

}  // namespace svchain
