// One source, compiled once for each set of instructions.
#define HWY_DISABLED_TARGETS (~(HWY_SSE4 | HWY_AVX2 | HWY_AVX3 | HWY_NEON | HWY_EMU128 | HWY_SCALAR))
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "algorithms/car/row_lighting.cpp"
#include "algorithms/car/row_lighting.h"

#include <Eigen/Geometry>
#include <hwy/foreach_target.h>
// Behind the above:
#include <hwy/highway.h>

#include "algorithms/car/display_table.h"

HWY_BEFORE_NAMESPACE();
namespace svchain::car::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<float, kMostLanes>;
using I = hn::RebindToSigned<D>;
using V = hn::Vec<D>;

HWY_INLINE V all(float value) {
  return hn::Set(D(), value);
}
HWY_INLINE V clamped(V v, float low, float high) {
  return hn::Min(hn::Max(v, all(low)), all(high));
}
HWY_INLINE V mixed(float a, float b, V t) {
  return hn::MulAdd(all(b - a), t, all(a));
}
HWY_INLINE V smooth(float from, float to, V x) {
  const V t = clamped(hn::Mul(hn::Sub(x, all(from)), all(1 / (to - from))), 0, 1);
  return hn::Mul(hn::Mul(t, t), hn::NegMulAdd(all(2), t, all(3)));
}

struct Vectors {
  V x, y, z;
};
HWY_INLINE V dot(const Vectors& a, const Vectors& b) {
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}
HWY_INLINE V dot(const Vectors& a, const Eigen::Vector3f& b) {
  return dot(a, {all(b.x()), all(b.y()), all(b.z())});
}
HWY_INLINE Vectors unit(const Vectors& a) {
  const V scale = hn::Div(all(1), hn::Sqrt(hn::Max(dot(a, a), all(1e-30f))));
  return {hn::Mul(a.x, scale), hn::Mul(a.y, scale), hn::Mul(a.z, scale)};
}
HWY_INLINE Vectors rays_at(const Rays& rays, V column, V row) {
  const auto at = [&](int axis) {
    return hn::MulAdd(column, all(rays.right[axis]),
                      hn::MulAdd(row, all(rays.down[axis]), all(rays.first[axis])));
  };
  return {at(0), at(1), at(2)};
}

/// Records of floats, one for each lane.
struct Records {
  const float* memory;
  hn::Vec<I> at;
  HWY_INLINE V operator[](size_t field) const { return hn::GatherIndex(D(), memory + field, at); }
  HWY_INLINE Vectors three(size_t field) const {
    return {(*this)[field], (*this)[field + 1], (*this)[field + 2]};
  }
};

/// What of the light does not depend on its colour's component.
struct Terms {
  V occlusion, towards_sun, scattered_up, mirrored_up;  // "up": shares of the ambient's upper end
  V below, above, over;                                 // shares within the sky
  V gloss, spot, grazing, mirrored_scale;
};

HWY_INLINE Terms terms_of(const Light& light, const Vectors& normal, const Vectors& to_eye, V height,
                          V gloss) {
  Terms t;
  const V cosine = dot(normal, to_eye), twice = hn::Add(cosine, cosine);
  const Vectors reflected = {hn::MulSub(twice, normal.x, to_eye.x), hn::MulSub(twice, normal.y, to_eye.y),
                             hn::MulSub(twice, normal.z, to_eye.z)};
  const V away = hn::Sub(all(1), clamped(cosine, 0, 1)), away2 = hn::Mul(away, away);
  t.grazing = hn::Mul(hn::Mul(away2, away2), away);
  t.occlusion = hn::MulAdd(all(0.65f), smooth(0, 0.4f, height), all(0.35f));
  t.towards_sun = hn::Max(all(0), dot(normal, light.to_sun));
  t.scattered_up = hn::MulAdd(all(0.5f), normal.z, all(0.5f));
  t.mirrored_up = hn::MulAdd(all(0.5f), reflected.z, all(0.5f));
  const V off = hn::Abs(reflected.z), rest = hn::Sub(all(1), off);
  t.below = hn::Min(all(1), hn::Mul(all(5), off));
  t.above = hn::NegMulAdd(rest, rest, all(1));
  t.over = smooth(-0.15f, 0.1f, reflected.z);
  t.gloss = gloss;
  const V k = hn::MulAdd(hn::Mul(all(400), gloss), gloss, all(4));
  const V s = hn::Max(all(0), dot(reflected, light.to_sun));
  t.spot = hn::Div(hn::Mul(hn::Mul(gloss, all(4)), s), hn::Add(hn::NegMulAdd(k, s, k), s));
  t.mirrored_scale = hn::Mul(hn::MulAdd(all(0.6f), gloss, all(0.4f)), t.occlusion);
  return t;
}

/// One component of the colour that reaches the eye.
HWY_INLINE V component(const Light& light, int c, const Terms& t, V scattering, V fresnel) {
  const float ground = light.ground[c], open = (light.zenith[c] + light.horizon[c]) * 0.5f;
  const V received =
      hn::MulAdd(mixed(ground, open, t.scattered_up), t.occlusion, hn::Mul(all(light.sun[c]), t.towards_sun));
  const V below = mixed(light.haze[c], ground, t.below),
          above = mixed(light.horizon[c], light.zenith[c], t.above);
  const V sky = hn::MulAdd(hn::Sub(above, below), t.over, below);
  const V around = mixed(ground, open, t.mirrored_up);
  const V mirrored = hn::MulAdd(all(light.sun[c]), t.spot, hn::MulAdd(hn::Sub(sky, around), t.gloss, around));
  return hn::MulAdd(scattering, received, hn::Mul(hn::Mul(fresnel, mirrored), t.mirrored_scale));
}

void light_samples(const Scenery& scenery, const int32_t* facets, const float* columns, const float* rows,
                   size_t count, float* rgba) {
  const D d;
  const I i;
  for (size_t k = 0; k < count; k += hn::Lanes(d)) {
    static_assert(sizeof(Facet) == 16 * sizeof(float) && sizeof(Substance) == 8 * sizeof(float));
    const Records facet = {scenery.facets->normal.data(), hn::ShiftLeft<4>(hn::LoadU(i, facets + k))};
    const Records substance = {scenery.substances->scattering.data(),
                               hn::ShiftLeft<3>(hn::ConvertTo(i, facet[12]))};
    const Vectors ray = rays_at(scenery.rays, hn::LoadU(d, columns + k), hn::LoadU(d, rows + k));
    const Vectors normal =
        unit({dot(ray, facet.three(0)), dot(ray, facet.three(3)), dot(ray, facet.three(6))});
    const Vectors towards = unit(ray), to_eye = {hn::Neg(towards.x), hn::Neg(towards.y), hn::Neg(towards.z)};
    const V z = hn::Add(hn::Div(ray.z, dot(ray, facet.three(9))), all(scenery.rays.eye.z()));
    const V gloss = substance[6], opacity = substance[7];
    const Terms terms = terms_of(scenery.light, normal, to_eye, hn::Mul(z, all(1 / scenery.top)), gloss);

    const Vectors f0 = substance.three(3), scattering = substance.three(0);
    const auto fresnel = [&](V f) { return hn::MulAdd(hn::Sub(all(1), f), terms.grazing, f); };
    const Vectors mirroring = {fresnel(f0.x), fresnel(f0.y), fresnel(f0.z)};
    const V mean = hn::Mul(hn::Add(hn::Add(mirroring.x, mirroring.y), mirroring.z), all(1 / 3.0f));
    hn::StoreInterleaved4(component(scenery.light, 0, terms, scattering.x, mirroring.x),
                          component(scenery.light, 1, terms, scattering.y, mirroring.y),
                          component(scenery.light, 2, terms, scattering.z, mirroring.z),
                          hn::MulAdd(hn::Sub(all(1), opacity), mean, opacity), d, rgba + 4 * k);
  }
}

/// As ContactShadow::shadow_at, where the ray meets the ground.
HWY_INLINE V shadow_of(const ContactShadow& shadow, const Vectors& ray, const Eigen::Vector3f& eye) {
  const V steps = hn::Div(all(-eye.z()), hn::Min(ray.z, all(-1e-20f)));
  const V x = hn::Abs(hn::MulAdd(steps, ray.x, all(eye.x()))),
          y = hn::Abs(hn::MulAdd(steps, ray.y, all(eye.y())));
  const V qx = hn::Add(x, all(shadow.radius() - shadow.half().x()));
  const V qy = hn::Add(y, all(shadow.radius() - shadow.half().y()));
  const V px = hn::Max(qx, all(0)), py = hn::Max(qy, all(0));
  const V outside = hn::Sqrt(hn::MulAdd(px, px, hn::Mul(py, py)));
  const V distance = hn::Add(outside, hn::Sub(hn::Min(hn::Max(qx, qy), all(0)), all(shadow.radius())));
  return hn::IfThenElseZero(hn::Lt(ray.z, all(0)), hn::Sub(all(1), smooth(0, shadow.soft(), distance)));
}

HWY_INLINE hn::Vec<I> level(V linear, V scale) {
  const V root = hn::Sqrt(clamped(hn::Mul(linear, all(1 / DisplayTable::kBrightest)), 0, 1));
  const auto step = hn::NearestInt(hn::Mul(root, all(DisplayTable::kLast)));
  return hn::NearestInt(hn::Mul(hn::GatherIndex(D(), DisplayTable::levels(), step), scale));
}

void encode_pixels(const Rays& rays, const ContactShadow& shadow, float opacity, int row, const float* rgba,
                   size_t count, uint32_t* bgra) {
  const D d;
  const I i;
  const V one = all(1);
  for (size_t k = 0; k < count; k += hn::Lanes(d)) {
    V r, g, b, alpha;
    hn::LoadInterleaved4(d, rgba + 4 * k, r, g, b, alpha);
    V covered = alpha;
    if (rays.eye.z() > 0 && !hn::AllTrue(d, hn::Ge(alpha, one))) {
      const V column = hn::ConvertTo(d, hn::Iota(i, static_cast<int32_t>(k)));
      const Vectors ray =
          rays_at(rays, hn::MulAdd(column, all(2), all(0.5f)), all(2 * static_cast<float>(row) + 0.5f));
      covered = hn::MulAdd(hn::Max(hn::Sub(one, alpha), all(0)), shadow_of(shadow, ray, rays.eye), alpha);
    }
    auto bytes = hn::ShiftLeft<24>(hn::NearestInt(hn::Mul(hn::Min(covered, one), all(255 * opacity))));
    if (!hn::AllTrue(d, hn::Le(alpha, all(0)))) {
      const V whole = hn::Div(one, hn::Max(alpha, all(1e-9f))), scale = hn::Mul(alpha, all(opacity));
      bytes = hn::Or(bytes, hn::Or(level(hn::Mul(b, whole), scale),
                                   hn::Or(hn::ShiftLeft<8>(level(hn::Mul(g, whole), scale)),
                                          hn::ShiftLeft<16>(level(hn::Mul(r, whole), scale)))));
    }
    hn::StoreU(hn::BitCast(hn::RebindToUnsigned<D>(), bytes), hn::RebindToUnsigned<D>(), bgra + k);
  }
}

}  // namespace svchain::car::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace svchain::car {

HWY_EXPORT(light_samples);
HWY_EXPORT(encode_pixels);

void light_samples(const Scenery& scenery, const int32_t* facets, const float* columns, const float* rows,
                   size_t count, float* rgba) {
  HWY_DYNAMIC_DISPATCH(light_samples)(scenery, facets, columns, rows, count, rgba);
}

void encode_pixels(const Rays& rays, const ContactShadow& shadow, float opacity, int row, const float* rgba,
                   size_t count, uint32_t* bgra) {
  HWY_DYNAMIC_DISPATCH(encode_pixels)(rays, shadow, opacity, row, rgba, count, bgra);
}

Substance::Substance(const Material& material) : gloss(material.gloss), opacity(material.opacity) {
  for (int c = 0; c < 3; ++c) {
    scattering[c] = material.base_colour[c] * (1 - material.metallic) * material.opacity;
    f0[c] = 0.04f + (material.base_colour[c] - 0.04f) * material.metallic;
  }
}

Facet facet_of(const std::array<const Vertex*, 3>& corners, const Eigen::Vector3f& eye, uint32_t part) {
  const Eigen::Vector3f a = corners[0]->position - eye, b = corners[1]->position - eye,
                        c = corners[2]->position - eye;
  const Eigen::Vector3f ca = b.cross(c), cb = c.cross(a), cc = a.cross(b);
  Facet facet;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3f row =
        -(corners[0]->normal[i] * ca + corners[1]->normal[i] * cb + corners[2]->normal[i] * cc);
    std::copy_n(row.data(), 3, &facet.normal[3 * i]);
  }
  // Of the plane by its edges: the sum of the three would cancel.
  const Eigen::Vector3f q = (b - a).cross(c - a) / (b - a).cross(c - a).dot(a);
  std::copy_n(q.data(), 3, facet.inverse_depth.data());
  facet.part = static_cast<float>(part);
  return facet;
}

}  // namespace svchain::car
#endif
