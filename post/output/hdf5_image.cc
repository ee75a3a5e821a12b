#include "post/output/hdf5_image.h"

#include <hdf5.h>

#include <array>
#include <new>
#include <string_view>
#include <utility>

#include "base/output_file.h"

namespace geneva::post {

namespace {

/// Of a file in memory nothing else can fail.
template <typename Result>
Result checked(const Result result) {
  if (result < 0) throw std::bad_alloc();
  return result;
}

template <typename Number>
hid_t type_of();
template <>
hid_t type_of<double>() {
  return H5T_NATIVE_DOUBLE;
}
template <>
hid_t type_of<unsigned int>() {
  return H5T_NATIVE_UINT;
}

using Sizes = std::array<hsize_t, 2>;

}  // namespace

/// Of an object of the library, released in the end.
class Hdf5Image::Handle {
 public:
  using Release = herr_t (*)(hid_t);
  Handle(const hid_t id, const Release release) : id_(id), release_(release) {}
  ~Handle() { release_(id_); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  [[nodiscard]] hid_t id() const { return id_; }

 private:
  hid_t id_;
  Release release_;
};

Hdf5Image::Hdf5Image() {
  H5Eset_auto(H5E_DEFAULT, nullptr, nullptr);  // failures are thrown, not printed
  constexpr std::size_t growth = 64U << 10U;   // so much of the end may be empty
  access_ = std::make_unique<Handle>(checked(H5Pcreate(H5P_FILE_ACCESS)), H5Pclose);
  checked(H5Pset_fapl_core(access_->id(), growth, 0));
  file_ = std::make_unique<Handle>(
      checked(H5Fcreate("in memory", H5F_ACC_TRUNC, H5P_DEFAULT, access_->id())), H5Fclose);
}

Hdf5Image::~Hdf5Image() = default;

void Hdf5Image::add_group(const std::string& name) {
  const Handle group(
      checked(H5Gcreate2(file_->id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT)),
      H5Gclose);
}

template <typename Number>
void Hdf5Image::add_table(const std::string& name, const std::size_t rows,
                          const std::size_t columns) {
  const Sizes sizes{rows, columns};
  const Handle space(checked(H5Screate_simple(columns == 0 ? 1 : 2, sizes.data(), nullptr)),
                     H5Sclose);
  const Handle table(checked(H5Dcreate2(file_->id(), name.c_str(), type_of<Number>(), space.id(),
                                        H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT)),
                     H5Dclose);
}

template <typename Number>
void Hdf5Image::fill(const std::string& name, const std::size_t first_row,
                     const std::vector<Number>& values) {
  if (values.empty()) return;
  const Handle table(checked(H5Dopen2(file_->id(), name.c_str(), H5P_DEFAULT)), H5Dclose);
  const Handle space(checked(H5Dget_space(table.id())), H5Sclose);
  Sizes sizes{0, 1};
  const int rank = checked(H5Sget_simple_extent_dims(space.id(), sizes.data(), nullptr));
  const Sizes start{first_row, 0};
  const Sizes count{values.size() / sizes[1], sizes[1]};
  checked(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(),
                              nullptr));
  const Handle memory(checked(H5Screate_simple(rank, count.data(), nullptr)), H5Sclose);
  checked(
      H5Dwrite(table.id(), type_of<Number>(), memory.id(), space.id(), H5P_DEFAULT, values.data()));
}

void Hdf5Image::write(const std::filesystem::path& file) const {
  checked(H5Fflush(file_->id(), H5F_SCOPE_GLOBAL));
  void* place = nullptr;
  checked(H5Fget_vfd_handle(file_->id(), access_->id(), &place));
  hsize_t size = 0;
  checked(H5Fget_filesize(file_->id(), &size));
  base::write_text(file, std::string_view(*static_cast<const char* const*>(place), size));
}

template void Hdf5Image::add_table<double>(const std::string&, std::size_t, std::size_t);
template void Hdf5Image::add_table<unsigned int>(const std::string&, std::size_t, std::size_t);
template void Hdf5Image::fill(const std::string&, std::size_t, const std::vector<double>&);
template void Hdf5Image::fill(const std::string&, std::size_t, const std::vector<unsigned int>&);

}  // namespace geneva::post
