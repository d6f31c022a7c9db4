#include "algorithms/car/gltf_values.h"

#include <cstring>

#include "algorithms/car/loose_model.h"

namespace svchain::car {
namespace {

template <class T>
T value_at(const unsigned char* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

template <class List>
const auto& member(const List& list, int number, const char* what) {
  if (number < 0 || static_cast<size_t>(number) >= list.size())
    throw ModelError{"refers to " + std::string(what) + " " + std::to_string(number) +
                     ", an index out of range; expected 0 to " +
                     std::to_string(static_cast<long>(list.size()) - 1)};
  return list[number];
}

/// Shares of whole numbers' greatest.
double greatest(int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return 127;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 255;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return 32767;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 65535;
    default:
      return 1;
  }
}

}  // namespace

GltfValues::GltfValues(const tinygltf::Model& document, int accessor) {
  const tinygltf::Accessor& a = member(document.accessors, accessor, "accessor");
  if (a.sparse.isSparse) throw ModelError{"has sparse accessors, which are not read; expected plain ones"};
  if (a.bufferView < 0) throw ModelError{"is compressed or has no data; expected plain buffers"};
  const tinygltf::BufferView& view = member(document.bufferViews, a.bufferView, "bufferView");
  const std::vector<unsigned char>& bytes = member(document.buffers, view.buffer, "buffer").data;

  const int component_bytes = tinygltf::GetComponentSizeInBytes(static_cast<uint32_t>(a.componentType));
  components_ = tinygltf::GetNumComponentsInType(static_cast<uint32_t>(a.type));
  if (component_bytes < 1 || components_ < 1 || components_ > 4)
    throw ModelError{"has an accessor of a type that no car needs; expected numbers or vectors"};
  component_bytes_ = static_cast<size_t>(component_bytes);
  count_ = a.count;
  type_ = a.componentType;
  normalised_ = a.normalized;
  const size_t value_bytes = component_bytes_ * components_;
  stride_ = view.byteStride != 0 ? view.byteStride : value_bytes;

  const size_t end = view.byteOffset + view.byteLength;
  const bool view_fits =
      view.byteOffset <= bytes.size() && view.byteLength <= bytes.size() && end <= bytes.size();
  const size_t within = view_fits && a.byteOffset <= view.byteLength ? view.byteLength - a.byteOffset : 0;
  if (count_ > 0 && (within < value_bytes || (count_ - 1) > (within - value_bytes) / stride_))
    throw ModelError{"promises more data than it has: accessor " + std::to_string(accessor) +
                     " has an index out of range"};
  if (count_ > 0) data_ = bytes.data() + view.byteOffset + a.byteOffset;
}

double GltfValues::component(const unsigned char* at) const {
  switch (type_) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return value_at<int8_t>(at);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return value_at<uint8_t>(at);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return value_at<int16_t>(at);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return value_at<uint16_t>(at);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return value_at<uint32_t>(at);
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return value_at<float>(at);
    default:
      throw ModelError{"has an accessor of a type that no car needs; expected floats or whole numbers"};
  }
}

Eigen::Vector4f GltfValues::vector(size_t value) const {
  Eigen::Vector4f v(0, 0, 0, 1);
  const double scale = normalised_ ? greatest(type_) : 1;
  for (int i = 0; i < components_; ++i)
    v[i] = static_cast<float>(component(data_ + value * stride_ + i * component_bytes_) / scale);
  return v;
}

uint32_t GltfValues::index(size_t value) const {
  const double number = component(data_ + value * stride_);
  return number >= 0 && number < UINT32_MAX ? static_cast<uint32_t>(number) : UINT32_MAX;
}

}  // namespace svchain::car
