#pragma once
// The car's shaders, OpenGL ES 3.0: lighting.h and contact_shadow.h of algorithms/car repeated, names and
// all. Surfaces are drawn in linear premultiplied r, g, b; laid over the picture they are as a display shows
// them, b, g, r.

namespace svchain::gl {

inline constexpr const char* kCarVertexShader = R"(#version 300 es
uniform mat4 clip_from_vehicle;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
out vec3 surface_place;
out vec3 surface_normal;
invariant gl_Position;

void main() {
  gl_Position = clip_from_vehicle * vec4(position, 1.0);
  surface_place = position;
  surface_normal = normal;
}
)";

inline constexpr const char* kCarFragmentShader = R"(#version 300 es
precision highp float;

uniform vec3 to_sun, sun, zenith, horizon, haze, ground;
uniform vec3 eye;
uniform float top;  // of the model, metres
uniform vec3 base_colour;
uniform float opacity, gloss, metallic;

in vec3 surface_place;
in vec3 surface_normal;
out vec4 lit;

vec3 sky(vec3 direction) {
  float off = abs(direction.z);
  vec3 below = mix(haze, ground, min(1.0, 5.0 * off));
  vec3 above = mix(horizon, zenith, 1.0 - (1.0 - off) * (1.0 - off));
  return mix(below, above, smoothstep(-0.15, 0.1, direction.z));
}

vec3 ambient(vec3 n) {
  return mix(ground, (zenith + horizon) * 0.5, 0.5 + 0.5 * n.z);
}

void main() {
  vec3 to_eye = normalize(eye - surface_place);
  vec3 n = normalize(surface_normal);
  if (!gl_FrontFacing) n = -n;  // a surface has two sides
  float towards = clamp(dot(n, to_eye), 0.0, 1.0);
  float occlusion = 0.35 + 0.65 * smoothstep(0.0, 0.4, surface_place.z / top);
  vec3 f0 = mix(vec3(0.04), base_colour, metallic);
  float away = 1.0 - towards;
  float grazing = away * away * away * away * away;
  vec3 fresnel = mix(f0, vec3(1.0), grazing);

  vec3 received = ambient(n) * occlusion + sun * max(0.0, dot(n, to_sun));
  vec3 scattered = base_colour * received * (1.0 - metallic);

  vec3 reflected = 2.0 * dot(n, to_eye) * n - to_eye;
  float t = max(0.0, dot(reflected, to_sun));
  float k = 4.0 + 400.0 * gloss * gloss;
  vec3 mirrored_light = mix(ambient(reflected), sky(reflected), gloss) + sun * (gloss * 4.0 * t / (k - k * t + t));
  vec3 mirrored = fresnel * mirrored_light * ((0.4 + 0.6 * gloss) * occlusion);
  lit = vec4(scattered * opacity + mirrored,
             opacity + (1.0 - opacity) * dot(fresnel, vec3(1.0 / 3.0)));
}
)";

inline constexpr const char* kLayVertexShader = R"(#version 300 es
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);  // of a triangle that covers everything
  gl_Position = vec4(corner * 4.0 - 1.0, 0.0, 1.0);
}
)";

inline constexpr const char* kLayFragmentShader = R"(#version 300 es
precision highp float;
precision highp sampler2D;

uniform sampler2D surfaces;
uniform vec2 rectangle;                      // where in the picture they begin
uniform vec3 eye, ray, ray_right, ray_down;  // the ray of place (0, 0), and from pixel to pixel
uniform vec2 half_size;                      // of the vehicle
uniform float width;
uniform float car_opacity;
out vec4 shown;

float shadow_at(vec2 place) {
  float radius = 0.1 * width;
  vec2 q = abs(place) - half_size + radius;
  float d = length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - radius;
  return 1.0 - smoothstep(0.0, 0.22 * width, d);
}

float shadow(vec3 along) {
  if (eye.z <= 0.0 || along.z >= 0.0) return 0.0;
  return shadow_at(eye.xy - (eye.z / along.z) * along.xy);
}

vec3 display(vec3 linear) {
  vec3 seen = linear * (1.0 + linear / 2.0) / (1.0 + linear);
  return pow(clamp(seen, 0.0, 1.0), vec3(1.0 / 2.2));
}

void main() {
  vec4 surface = texelFetch(surfaces, ivec2(gl_FragCoord.xy - rectangle), 0);
  vec3 bgr = surface.a > 0.0 ? display(surface.bgr / surface.a) * surface.a : vec3(0.0);
  float dark = surface.a < 1.0 ? shadow(ray + gl_FragCoord.x * ray_right + gl_FragCoord.y * ray_down) : 0.0;
  shown = vec4(bgr, min(1.0, surface.a + (1.0 - surface.a) * dark)) * car_opacity;
}
)";

}  // namespace svchain::gl
