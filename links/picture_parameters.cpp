#include "links/picture_parameters.h"

#include "algorithms/colour/yuv.h"

namespace svchain {

namespace {

constexpr const char* kUsualColour = "bt601_limited";

bool is_yuv(const std::string& type) {
  return type != "bgr8" && type != "bgrx8";
}

}  // namespace

std::vector<ParameterDescription> picture_parameters(const std::string& prefix,
                                                     const std::vector<std::string>& types) {
  ParameterDescription colour =
      choice(prefix + "colour", kUsualColour, colour::yuv_encoding_names(),
             std::string("standard and range of YUV; ") + kUsualColour + " where left out");
  colour.fallback = nullptr;  // so that one given for bgr8 is noticed
  return {choice(prefix + "format", "bgr8", types, "format of the pictures"), colour};
}

PictureKind picture_kind(Configuration& configuration, const std::string& prefix) {
  const Parameters& given = configuration.parameters();
  PictureKind kind{given.text(prefix + "format"), given.text(prefix + "colour")};
  if (!is_yuv(kind.type) && !kind.colour.empty()) {
    configuration.parameter_fault(
        prefix + "colour", "goes with " + prefix + "format nv12 or yuyv, but the format is " + kind.type);
  }
  if (is_yuv(kind.type) && kind.colour.empty()) kind.colour = kUsualColour;
  return kind;
}

Format picture_format(Configuration& configuration, const std::string& prefix, const PictureKind& kind,
                      int width_px, int height_px, const std::string& what) {
  if (kind.type == "bgr8") return Format::bgr8(width_px, height_px);
  if (kind.type == "bgrx8") return Format::bgrx8(width_px, height_px);
  const bool nv12 = kind.type == "nv12";
  if (width_px % 2 != 0 || (nv12 && height_px % 2 != 0)) {
    configuration.parameter_fault(
        prefix + "format", kind.type + " needs an even width" + (nv12 ? " and height, " : ", ") + what +
                               " is " + std::to_string(width_px) + "x" + std::to_string(height_px) + " px");
  }
  return nv12 ? Format::nv12(width_px, height_px, kind.colour)
              : Format::yuyv(width_px, height_px, kind.colour);
}

void check_colours(Configuration& configuration, int input_port) {
  for (const Format& format : configuration.input(input_port)) {
    if (!is_yuv(format.type) || colour::yuv_encoding(format.colour)) continue;
    configuration.format_fault(input_port, "colour", spoken_list(colour::yuv_encoding_names()),
                               "\"" + format.colour + "\"");
  }
}

}  // namespace svchain
