#pragma once
// The bowl's shaders, OpenGL ES 3.0: what synthesis::synthesize does to a pixel (synthesize.h), with the
// places and weights of the mesh table's vertices. FIRST_YUV and SECOND_YUV say of which format a camera is,
// BLENDED that there are two of them, FALLOFF that samples are multiplied by 1 + a1 q^2 + a2 q^4
// (synthesis/fixed_point.h). Colours are b, g, r.

namespace svchain::gl {

inline constexpr const char* kBowlVertexShader = R"(
uniform mat4 clip_from_unit;
layout(location = 0) in vec3 position;
layout(location = 1) in float weight;
layout(location = 2) in vec4 texture_places;
out vec2 first_place;
#ifdef BLENDED
out vec2 second_place;
out float first_weight;
#endif

void main() {
  gl_Position = clip_from_unit * vec4(position, 1.0);
  first_place = texture_places.xy;
#ifdef BLENDED
  second_place = texture_places.zw;
  first_weight = weight;
#endif
}
)";

inline constexpr const char* kBowlFragmentShader = R"(
precision highp float;
precision highp int;
precision highp sampler2D;

struct Camera {
  int number;
  vec2 size_px;
  vec2 group;         // pixels that share their chroma
  mat4x3 bgr_of_yuv;  // of y, u, v, 1
  vec2 falloff;       // a1, a2
  vec3 lens;          // its centre in pixels, and 2 / width
};
uniform Camera first, second;
uniform sampler2D first_picture, first_chroma, second_picture, second_chroma;
uniform sampler2D curves;  // a row for every camera, of b, g, r

in vec2 first_place;
#ifdef BLENDED
in vec2 second_place;
in float first_weight;
#endif
out vec4 shown;

// Bilinear between pixels that have the chroma of their group: it changes only from the last pixel of one
// group to the first of the next.
vec3 yuv_sample(Camera camera, sampler2D luma, sampler2D chroma, vec2 place) {
  vec2 pixel = place * camera.size_px - 0.5;
  vec2 start = floor(pixel / camera.group) * camera.group;
  vec2 between = max(pixel - start - (camera.group - 1.0), 0.0);
  vec2 chroma_place = (start + camera.group * (between + 0.5)) / camera.size_px;
  return clamp(camera.bgr_of_yuv * vec4(texture(luma, place).r, texture(chroma, chroma_place).rg, 1.0), 0.0, 1.0);
}

vec3 mapped(Camera camera, vec2 place, vec3 bgr) {
#ifdef FALLOFF
  vec2 off = (place * camera.size_px - camera.lens.xy) * camera.lens.z;
  float q2 = min(dot(off, off), 4.0);
  bgr = min(bgr * clamp(1.0 + q2 * (camera.falloff.x + camera.falloff.y * q2), 0.0, 16.0), 1.0);
#endif
  ivec3 level = ivec3(bgr * 255.0 + 0.5);
  return vec3(texelFetch(curves, ivec2(level.r, camera.number), 0).r,
              texelFetch(curves, ivec2(level.g, camera.number), 0).g,
              texelFetch(curves, ivec2(level.b, camera.number), 0).b);
}

void main() {
#ifdef FIRST_YUV
  vec3 bgr = yuv_sample(first, first_picture, first_chroma, first_place);
#else
  vec3 bgr = texture(first_picture, first_place).rgb;
#endif
  bgr = mapped(first, first_place, bgr);
#ifdef BLENDED
#ifdef SECOND_YUV
  vec3 other = yuv_sample(second, second_picture, second_chroma, second_place);
#else
  vec3 other = texture(second_picture, second_place).rgb;
#endif
  bgr = mix(mapped(second, second_place, other), bgr, first_weight);
#endif
  shown = vec4(bgr, 1.0);
}
)";

}  // namespace svchain::gl
