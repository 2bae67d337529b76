// What HDF5 must not be asked to read: datasets that lie elsewhere, that are declared larger than what is
// stored, or whose chunks are shorter than they must be. In results (read_h5()) and in influence files behind
// a new seal.
#include "bem_contact/h5/table.hpp"
#include "sample_function.hpp"

#include <gmock/gmock.h>
#include <hdf5.h>

#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <functional>
#include <random>
#include <sys/stat.h>
#include <zlib.h>

using namespace bem_contact;
using testing::AllOf;
using testing::HasSubstr;

namespace {

constexpr hsize_t kernel_shape[] = {11, 45}, one_row[] = {1, 45}, huge[] = {20'000'000'000, 45};

struct Storage {
  hid_t list = H5Pcreate(H5P_DATASET_CREATE);
  const hsize_t* shape = kernel_shape;
  bool written = true;
};

/// A dataset of the kernel's shape, which no other has, or a larger one.
void make(hid_t file, const Storage& how) {
  const hid_t space = H5Screate_simple(2, how.shape, nullptr);
  const hid_t set = H5Dcreate2(file, "kernel", H5T_IEEE_F64LE, space, H5P_DEFAULT, how.list, H5P_DEFAULT);
  ASSERT_GE(set, 0);
  const std::vector<double> values(kernel_shape[0] * kernel_shape[1], 1.0);
  if (how.written) {
    ASSERT_GE(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  }
  H5Dclose(set);
  H5Sclose(space);
  H5Pclose(how.list);
}

Storage chunked(bool checksum) {
  Storage how;
  H5Pset_chunk(how.list, 2, one_row);
  if (checksum)
    H5Pset_fletcher32(how.list);
  return how;
}

using Damage = std::function<void(hid_t file)>;
using Patch = std::function<void(std::string& bytes)>;

class DamagedDatasets : public testing::Test {
protected:
  static void unlink_kernel(hid_t file) {
    if (H5Lexists(file, "kernel", H5P_DEFAULT) > 0)
      H5Ldelete(file, "kernel", H5P_DEFAULT);
  }
  /// Opens the file, damages it and perhaps its bytes.
  static void change(const std::filesystem::path& file, const Damage& damage, const Patch& patch) {
    const hid_t opened = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    ASSERT_GE(opened, 0);
    unlink_kernel(opened);
    damage(opened);
    H5Fclose(opened);
    if (patch) {
      std::string bytes = text_of(file);
      patch(bytes);
      std::ofstream(file, std::ios::binary) << bytes;
    }
  }
  /// What readers say of a result and of an influence file with that damage.
  std::string of_result(const Damage& damage, const Patch& patch = {}) const {
    const auto file = folder_ / "result.h5";
    H5Fclose(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)); // as h5py makes one
    change(file, damage, patch);
    return message_of([&] { read_h5(file); });
  }
  std::string of_influence(const Damage& damage, const Patch& patch = {}) const {
    const auto file = folder_ / "influence.h5";
    write_influence_file(file, sample_function());
    change(file, damage, patch);
    seal_again(file);
    return message_of([&] { read_influence_file(file); });
  }
  void expect_refused(const Damage& damage, const char* words, const Patch& patch = {}) const {
    EXPECT_THAT(of_result(damage, patch), AllOf(HasSubstr("result.h5' is damaged"), HasSubstr(words)));
    EXPECT_THAT(of_influence(damage, patch), AllOf(HasSubstr("influence.h5' is damaged"), HasSubstr(words)));
  }

  const TemporaryFolder folder_;
};

/// The stored size of the first chunk of the first dataset of chunks: a key of a B-tree of version 1.
void declare_chunk_size(std::string& bytes, std::uint32_t size) {
  constexpr std::size_t to_first_key = 24;
  const std::size_t node = bytes.find(std::string("TREE\1", 5));
  ASSERT_NE(node, std::string::npos);
  std::memcpy(&bytes[node + to_first_key], &size, sizeof size);
}

TEST_F(DamagedDatasets, OfWholeOnesNothingIsSaid) {
  for (const bool checksum : {false, true}) {
    const Damage none = [&](hid_t file) { make(file, chunked(checksum)); };
    EXPECT_EQ(of_result(none), "no error");
    EXPECT_THAT(of_influence(none), Not(HasSubstr("damaged"))); // it is no kernel: all numbers are one
  }
  EXPECT_EQ(of_result([](hid_t file) { make(file, {}); }), "no error");
  // Compressed, as h5repack does it.
  EXPECT_EQ(of_result([](hid_t file) {
              Storage how = chunked(false);
              H5Pset_shuffle(how.list);
              H5Pset_deflate(how.list, 6);
              H5Pset_fletcher32(how.list);
              make(file, how);
            }),
            "no error");
}

TEST_F(DamagedDatasets, InOtherFilesAreRefused) {
  const auto other = folder_ / "other.h5", pipe = folder_ / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const hid_t made = H5Fcreate(other.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  make(made, {});
  H5Fclose(made);
  for (const auto& target : {other, pipe}) {
    const Damage link = [&](hid_t file) {
      H5Lcreate_external(target.c_str(), "/kernel", file, "kernel", H5P_DEFAULT, H5P_DEFAULT);
    };
    EXPECT_THAT(of_influence(link), AllOf(HasSubstr("'kernel'"), HasSubstr("a link to another place")));
    EXPECT_EQ(of_result(link), "no error"); // links are passed over: the result has no such dataset
    expect_refused(
        [&](hid_t file) {
          Storage how{.written = false};
          H5Pset_external(how.list, target.c_str(), 0, 8 * 11 * 45);
          make(file, how);
        },
        "lies in another file");
    expect_refused(
        [&](hid_t file) {
          Storage how{.written = false};
          const hid_t space = H5Screate_simple(2, kernel_shape, nullptr);
          H5Pset_virtual(how.list, space, target.c_str(), "/kernel", space);
          H5Sclose(space);
          make(file, how);
        },
        "lies in another file");
  }
}

TEST_F(DamagedDatasets, LargerThanWhatIsStoredAreRefused) {
  for (const hsize_t* shape : {kernel_shape, huge}) {
    SCOPED_TRACE(shape[0]);
    expect_refused([&](hid_t file) { make(file, {.shape = shape, .written = false}); }, "0 are stored");
    for (const bool deflated : {false, true})
      expect_refused(
          [&](hid_t file) {
            Storage how = chunked(false);
            how.shape = shape;
            how.written = false;
            if (deflated)
              H5Pset_deflate(how.list, 6);
            make(file, how);
          },
          "0 are stored");
  }
}

/// HDF5 subtracts the four bytes of the checksum unchecked, and reads a chunk as if it were whole.
TEST_F(DamagedDatasets, ChunksThatAreTooShortAreRefused) {
  for (const bool checksum : {true, false})
    for (const std::uint32_t size : {0, 1, 2, 3, 4, 12, 359, 365, 1'000'000, -1}) {
      SCOPED_TRACE(size);
      const Patch patch = [&](std::string& bytes) { declare_chunk_size(bytes, size); };
      const Damage none = [&](hid_t file) { make(file, chunked(checksum)); };
      EXPECT_THAT(of_result(none, patch), HasSubstr("is damaged"));
    }
  // The format's own table, which comes first in the file.
  for (const std::uint32_t size : {0, 1, 2, 3, 4, 12, -1}) {
    const auto file = folder_ / "influence.h5";
    write_influence_file(file, sample_function());
    std::string bytes = text_of(file);
    declare_chunk_size(bytes, size);
    std::ofstream(file, std::ios::binary) << bytes;
    seal_again(file);
    EXPECT_THAT(message_of([&] { read_influence_file(file); }), HasSubstr("is damaged")) << size;
  }
}

/// Which HDF5 reads beyond its end, too.
TEST_F(DamagedDatasets, DeflatedChunksThatBecomeTooShortAreRefused) {
  for (const std::size_t numbers : {44, 45, 46}) {
    std::vector<double> values(numbers, 1.0);
    std::vector<Bytef> deflated(1000);
    uLongf bytes = deflated.size();
    ASSERT_EQ(compress(deflated.data(), &bytes, reinterpret_cast<const Bytef*>(values.data()), 8 * numbers),
              Z_OK);
    const Damage damage = [&](hid_t file) {
      Storage how = chunked(false);
      H5Pset_deflate(how.list, 6);
      make(file, how);
      const hid_t set = H5Dopen2(file, "kernel", H5P_DEFAULT);
      const hsize_t at[] = {3, 0};
      EXPECT_GE(H5Dwrite_chunk(set, H5P_DEFAULT, 0, at, bytes, deflated.data()), 0);
      H5Dclose(set);
    };
    if (numbers == 45)
      EXPECT_EQ(of_result(damage), "no error");
    else
      expect_refused(damage, "not as long as it must be");
  }
}

/// HDF5 leaves a filter out where it gains nothing.
TEST_F(DamagedDatasets, ChunksThatDeflateGainsNothingOnAreRead) {
  EXPECT_EQ(of_result([](hid_t file) {
              Storage how = chunked(true);
              H5Premove_filter(how.list, H5Z_FILTER_FLETCHER32);
              H5Pset_deflate(how.list, 0); // larger than what it holds
              H5Pset_fletcher32(how.list);
              make(file, how);
            }),
            "no error");
}

H5Table sample_table(bool checksums) {
  H5Table table;
  table.checksums = checksums;
  const std::vector<double> values{1, 2, 3, 4, 5, 6};
  for (const char* name : {"axes/force", "values/Fx", "values/Fy", "values/Fz"})
    table.datasets[name] = {{2, 3}, values, "N", "six numbers"};
  table.datasets["scale/Fx"] = H5Dataset::single(7, "N", "a single number");
  for (int i = 0; i < 12; ++i) { // more than HDF5 keeps in a group's header
    table.datasets[fmt::format("more/{}", i)] = H5Dataset::line({1, 2}, "mm", "two numbers");
    table.attributes[fmt::format("attribute_{}", i)] = static_cast<double>(i);
  }
  table.attributes["format"] = std::string("a sample");
  return table;
}

bool same(const H5Table& a, const H5Table& b) {
  const auto of = [](const H5Table& table) {
    std::map<std::string, std::vector<double>> values;
    for (const auto& [name, data] : table.datasets)
      values[name] = data.values;
    return values;
  };
  return of(a) == of(b) && a.attributes == b.attributes;
}

/// Places all over the file. HDF5 1.10.8 ended the process where it found a damaged link in a large group.
TEST_F(DamagedDatasets, NoFlippedBitOfATableIsReadAndNoneEndsTheProcess) {
  for (const bool checksums : {true, false}) {
    const auto file = folder_ / "t.h5";
    const H5Table table = sample_table(checksums);
    write_h5(file, table);
    EXPECT_TRUE(same(read_h5(file), table));
    EXPECT_EQ(read_h5(file).checksums, checksums);
    const std::string whole = text_of(file);
    std::mt19937 random(20261127);
    int refused = 0, other = 0;
    for (std::size_t at = 0; at < whole.size(); at += 1 + random() % 16) {
      std::string bytes = whole;
      bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
      std::filesystem::remove(file);
      std::ofstream(file, std::ios::binary) << bytes;
      const std::string said = message_of([&] { other += !same(read_h5(file), table); });
      refused += said != "no error";
    }
    EXPECT_GT(refused, 100);
    if (checksums) {
      EXPECT_EQ(other, 0);
    }
  }
}

} // namespace
