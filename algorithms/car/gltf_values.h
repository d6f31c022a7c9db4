#pragma once
// Numbers out of a glTF document's buffers, every access checked. Internal to this room; borrows the
// document.

#include <Eigen/Core>
#include <tiny_gltf.h>

namespace svchain::car {

/// The values of one accessor: vectors of up to four components, normalised ones as 0..1 or -1..1.
class GltfValues {
 public:
  /// Throws ModelError where the document does not hold what the accessor promises.
  GltfValues(const tinygltf::Model& document, int accessor);

  size_t count() const { return count_; }
  int components() const { return components_; }
  /// Of a value that exists; components that there are not are 0, the fourth 1.
  Eigen::Vector4f vector(size_t value) const;
  /// Of a scalar of whole numbers.
  uint32_t index(size_t value) const;

 private:
  double component(const unsigned char* at) const;

  const unsigned char* data_ = nullptr;
  size_t count_ = 0, stride_ = 0, component_bytes_ = 0;
  int components_ = 0, type_ = 0;
  bool normalised_ = false;
};

}  // namespace svchain::car
