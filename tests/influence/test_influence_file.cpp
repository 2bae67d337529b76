#include "bem_contact/influence/file_seal.hpp"
#include "bem_contact/influence/influence_file.hpp"
#include "bem_contact/influence/requirements.hpp"
#include "bem_contact/influence/stress_kernel_file.hpp"
#include "sample_function.hpp"

#include <gmock/gmock.h>
#include <hdf5.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>

using namespace bem_contact;
using testing::AllOf;
using testing::HasSubstr;

namespace {

void write_bytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

std::string reading(const std::filesystem::path& file) {
  return message_of([&] { read_influence_file(file); });
}

} // namespace

TEST(InfluenceFile, ReadsWhatWasWritten) {
  const TemporaryFolder folder;
  InfluenceFunction f = sample_function();
  f.held = ""; // an empty text is a text
  write_influence_file(folder / "a.h5", f);
  const InfluenceFunction g = read_influence_file(folder / "a.h5");
  EXPECT_EQ(g.body, f.body);
  EXPECT_EQ(g.profile, f.profile);
  EXPECT_EQ(g.profile_digest, f.profile_digest);
  EXPECT_EQ(g.material, f.material);
  EXPECT_EQ(g.held, f.held);
  EXPECT_EQ(g.method, f.method);
  EXPECT_EQ(g.invariance, f.invariance);
  EXPECT_EQ(g.reference_radius, f.reference_radius);
  EXPECT_EQ(g.half_period, f.half_period);
  EXPECT_EQ(g.station_width, f.station_width);
  ASSERT_EQ(g.stations.size(), f.stations.size());
  for (std::size_t i = 0; i < f.stations.size(); ++i) {
    EXPECT_EQ(g.stations[i].s, f.stations[i].s);
    EXPECT_EQ(g.stations[i].position.y, f.stations[i].position.y);
    EXPECT_EQ(g.stations[i].position.z, f.stations[i].position.z);
    EXPECT_EQ(g.stations[i].delta, f.stations[i].delta);
  }
  EXPECT_EQ(g.wavenumber, f.wavenumber);
  EXPECT_EQ(g.kernel, f.kernel);
  EXPECT_EQ(g.remote, f.remote);
  EXPECT_EQ(g.remote_self, f.remote_self);
  EXPECT_EQ(g.betti_error, f.betti_error);
  EXPECT_EQ(g.reaction_error, f.reaction_error);
  EXPECT_EQ(g.estimated_error, f.estimated_error);
}

TEST(InfluenceFile, BodyOfRevolutionKeepsItsRadius) {
  const TemporaryFolder folder;
  InfluenceFunction f = sample_function();
  f.invariance = Invariance::revolution;
  f.reference_radius = 460;
  f.half_period = std::numbers::pi * 460;
  write_influence_file(folder / "a.h5", f);
  const InfluenceFunction g = read_influence_file(folder / "a.h5");
  EXPECT_EQ(g.invariance, Invariance::revolution);
  EXPECT_EQ(g.reference_radius, 460);
}

StressKernel sample_stresses() {
  const auto numbers = [](std::size_t count) {
    std::vector<float> out;
    for (std::size_t i = 0; i < count; ++i)
      out.push_back(0.25F * static_cast<float>(i % 7) - 0.5F);
    return out;
  };
  const StressForm form{.wavenumber = {0, 0.5},
                        .left_rank = {3, 1},
                        .right_rank = {2, 1},
                        .left = numbers(4 * 12),
                        .right = numbers(3 * 3 * sample_function().station_count()),
                        .core = numbers(2 * (6 + 1))};
  return {.places = {{0, {0, 0}, 0}, {1, {1, 0}, 0.1}},
          .depths = {1, 2},
          .there = {1, 1, 1, 0},
          .remainder = form,
          .error = form};
}

TEST(InfluenceFile, StressesComeBackAsTheyWere) {
  const TemporaryFolder folder;
  const StressKernel stresses = sample_stresses();
  write_influence_file(folder / "a.h5", sample_function(), stresses);
  write_packed_influence_file(folder / "packed.h5", sample_function(), stresses);
  for (const char* name : {"a.h5", "packed.h5"}) {
    EXPECT_THAT(text_of(folder / name).substr(0, 100), HasSubstr("format 1.2"));
    EXPECT_EQ(read_influence_file(folder / name).stations.size(), sample_function().stations.size());
    const StressKernel read = read_stress_kernel(folder / name);
    EXPECT_EQ(read.depths, stresses.depths);
    EXPECT_EQ(read.there, stresses.there);
    EXPECT_EQ(read.places[1].delta, 0.1);
    for (const auto& [found, right] :
         {std::pair{&read.remainder, &stresses.remainder}, {&read.error, &stresses.error}}) {
      EXPECT_EQ(found->wavenumber, right->wavenumber);
      EXPECT_EQ(found->left_rank, right->left_rank);
      EXPECT_EQ(found->right_rank, right->right_rank);
      EXPECT_EQ(found->core, right->core);
      EXPECT_EQ(found->left, right->left);
      EXPECT_EQ(found->right, right->right);
    }
    EXPECT_EQ(read.remainder.place_of(1).core, 6U);
  }
  write_influence_file(folder / "none.h5", sample_function());
  EXPECT_TRUE(read_stress_kernel(folder / "none.h5").empty());
}

TEST(InfluenceFile, RefusesStressesThatAreNotWhole) {
  const auto refused = [](const std::function<void(StressKernel&)>& change) {
    StressKernel stresses = sample_stresses();
    change(stresses);
    return message_of([&] { validate(stresses, sample_function().station_count()); });
  };
  EXPECT_EQ(refused([](StressKernel&) {}), "no error");
  EXPECT_THAT(refused([](StressKernel& k) { k.depths = {2, 1}; }), HasSubstr("do not ascend"));
  EXPECT_THAT(refused([](StressKernel& k) { k.there.pop_back(); }), HasSubstr("whether the body is there"));
  EXPECT_THAT(refused([](StressKernel& k) { k.remainder.left_rank[0] = 2; }), HasSubstr("do not fit"));
  EXPECT_THAT(refused([](StressKernel& k) { k.error.right_rank[0] = -1; }), HasSubstr("numbers of columns"));
  EXPECT_THAT(refused([](StressKernel& k) { k.remainder.left[3] = NAN; }), HasSubstr("not finite"));
  EXPECT_THAT(refused([](StressKernel& k) { k.remainder.wavenumber[0] = 0.1; }), HasSubstr("wavenumbers"));
}

TEST(InfluenceFile, SameNumbersGiveTheSameBytes) {
  const TemporaryFolder folder;
  write_influence_file(folder / "a.h5", sample_function());
  write_influence_file(folder / "b.h5", sample_function());
  EXPECT_EQ(text_of(folder / "a.h5"), text_of(folder / "b.h5"));
}

TEST(InfluenceFile, IsWholeOrAbsent) {
  const TemporaryFolder folder;
  InfluenceFunction f = sample_function();
  f.kernel[0] = -1;
  EXPECT_THAT(message_of([&] { write_influence_file(folder / "a.h5", f); }), HasSubstr("diagonal"));
  EXPECT_FALSE(std::filesystem::exists(folder / "a.h5"));
  EXPECT_THAT(message_of([&] { write_influence_file(folder / "none" / "a.h5", sample_function()); }),
              AllOf(HasSubstr("cannot be written"), HasSubstr("Make the folder")));
  write_influence_file(folder / "a.h5", sample_function());
  f = sample_function();
  f.body = "another";
  write_influence_file(folder / "a.h5", f); // replaces the old file in one step
  EXPECT_EQ(read_influence_file(folder / "a.h5").body, "another");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / ""), {}), 1);
}

TEST(InfluenceFile, RefusesWhatIsNoInfluenceFile) {
  const TemporaryFolder folder;
  EXPECT_THAT(reading(folder / "none.h5"), AllOf(HasSubstr("cannot be opened"), HasSubstr("no such file")));
  EXPECT_THAT(reading(folder / ""), HasSubstr("not a regular file"));
  write_bytes(folder / "empty.h5", "");
  EXPECT_THAT(reading(folder / "empty.h5"), HasSubstr("is no influence file"));
  write_bytes(folder / "text.h5", "y z\n1 2\n");
  EXPECT_THAT(reading(folder / "text.h5"), HasSubstr("is no influence file"));
}

TEST(InfluenceFile, RefusesTruncatedAlteredAndForeignVersions) {
  const TemporaryFolder folder;
  write_influence_file(folder / "a.h5", sample_function());
  const std::string whole = text_of(folder / "a.h5");

  write_bytes(folder / "b.h5", whole.substr(0, whole.size() - 100));
  EXPECT_THAT(reading(folder / "b.h5"),
              AllOf(HasSubstr("is truncated"), HasSubstr("of " + std::to_string(whole.size()))));
  write_bytes(folder / "b.h5", whole.substr(0, 300));
  EXPECT_THAT(reading(folder / "b.h5"), HasSubstr("is truncated"));

  std::string altered = whole;
  altered[whole.size() / 2] = static_cast<char>(altered[whole.size() / 2] ^ 1);
  write_bytes(folder / "b.h5", altered);
  EXPECT_THAT(reading(folder / "b.h5"), AllOf(HasSubstr("was altered"), HasSubstr("checksum")));
  write_bytes(folder / "b.h5", whole + "more");
  EXPECT_THAT(reading(folder / "b.h5"), HasSubstr("was altered"));

  std::string newer = whole;
  newer.replace(newer.find("format 1"), 8, "format 2");
  write_bytes(folder / "b.h5", newer);
  EXPECT_THAT(reading(folder / "b.h5"), AllOf(HasSubstr("format version 2.0"), HasSubstr("reads version 1")));
}

TEST(InfluenceFile, NoFlippedByteAndNoTruncationIsAccepted) {
  const TemporaryFolder folder;
  write_influence_file(folder / "a.h5", sample_function());
  const std::string whole = text_of(folder / "a.h5");
  std::mt19937 random(20240229);
  for (int run = 0; run < 300; ++run) {
    std::string bytes = whole;
    if (run % 3 == 0) {
      bytes.resize(random() % whole.size());
    } else {
      // Every other flip in the first 1024 bytes, where the seal and HDF5's own headers are.
      const std::size_t at = random() % (run % 3 == 1 ? 1024 : whole.size());
      bytes[at] = static_cast<char>(bytes[at] ^ (1 + random() % 255));
    }
    write_bytes(folder / "b.h5", bytes);
    EXPECT_NE(reading(folder / "b.h5"), "no error") << run;
  }
}

/// As files of others, and those from before there was a fifth line.
TEST(InfluenceFile, ASealOfFourLinesHoldsByItsSha256) {
  const TemporaryFolder folder;
  write_influence_file(folder / "a.h5", sample_function());
  const std::string whole = text_of(folder / "a.h5");
  const std::size_t fifth = whole.find("xxh3 ");
  ASSERT_LT(fifth, seal_size);
  std::string four = whole;
  std::fill(four.begin() + std::ptrdiff_t(fifth), four.begin() + std::ptrdiff_t(seal_size), '\0');
  write_bytes(folder / "b.h5", four);
  EXPECT_EQ(reading(folder / "b.h5"), "no error");
  EXPECT_EQ(check_seal(folder / "b.h5", influence_format_major),
            check_seal(folder / "a.h5", influence_format_major));
  for (const std::size_t at : {std::size_t(80), fifth - 3, seal_size + 100, whole.size() - 1}) {
    std::string bytes = four;
    bytes[at] = static_cast<char>(bytes[at] ^ 1);
    write_bytes(folder / "b.h5", bytes);
    EXPECT_NE(reading(folder / "b.h5"), "no error") << at;
  }
}

TEST(InfluenceFile, RefusesSealedFilesWithOtherContents) {
  // As another program may write them: the seal holds and the contents do not fit the format.
  const TemporaryFolder folder;
  const auto after = [&](const std::function<void(hid_t)>& change) {
    write_influence_file(folder / "a.h5", sample_function());
    const hid_t file = H5Fopen((folder / "a.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    change(file);
    H5Fclose(file);
    seal_again(folder / "a.h5");
    return reading(folder / "a.h5");
  };
  const auto set_text = [](const char* name, const char* text) {
    return [=](hid_t file) { // of variable length, as h5py writes it
      H5Adelete(file, name);
      const hid_t type = H5Tcopy(H5T_C_S1), space = H5Screate(H5S_SCALAR);
      H5Tset_size(type, H5T_VARIABLE);
      const hid_t attribute = H5Acreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
      H5Awrite(attribute, type, &text);
      H5Aclose(attribute);
      H5Sclose(space);
      H5Tclose(type);
    };
  };
  EXPECT_EQ(after(set_text("profile", "60E2")), "no error");
  EXPECT_THAT(after(set_text("invariance", "prosaical")), HasSubstr("invariance 'prosaical'"));
  EXPECT_THAT(after(set_text("poisson", "0.3")), AllOf(HasSubstr("'poisson'"), HasSubstr("right type")));
  EXPECT_THAT(after([](hid_t file) { H5Adelete(file, "poisson"); }), HasSubstr("the attribute poisson"));
  EXPECT_THAT(after([](hid_t file) { H5Ldelete(file, "remote_self", H5P_DEFAULT); }),
              HasSubstr("the table remote_self"));
  EXPECT_THAT(after([](hid_t file) {
                H5Ldelete(file, "remote", H5P_DEFAULT);
                H5Lcreate_hard(file, "remote_self", file, "remote", H5P_DEFAULT, H5P_DEFAULT);
              }),
              AllOf(HasSubstr("table 'remote'"), HasSubstr("wrong shape")));
}

TEST(InfluenceFile, RequirementsNameWhatDoesNotFit) {
  const InfluenceFunction f = sample_function();
  EXPECT_NO_THROW(require_profile(f, "60E1 again", f.profile_digest));
  EXPECT_THAT(message_of([&] { require_profile(f, "54E1", 7); }),
              AllOf(HasSubstr("do not belong to the profile '54E1'"), HasSubstr("'60E1'")));
  EXPECT_NO_THROW(require_material(f, f.material));
  EXPECT_THAT(message_of([&] {
                require_material(f, {82000, 0.28});
              }),
              AllOf(HasSubstr("do not belong to this material"), HasSubstr("81999.5"), HasSubstr("0.28")));
  EXPECT_NO_THROW(require_strip(f, -31.125, -30.375));
  EXPECT_THAT(message_of([&] { require_strip(f, -31.2, -30.5); }),
              AllOf(HasSubstr("leaves the contact strip"), HasSubstr("cover s = -31.125 to -30.375")));
  EXPECT_THAT(message_of([&] { require_strip(f, -31, -30.3); }), HasSubstr("leaves the contact strip"));
  EXPECT_THAT(message_of([&] { require_strip(f, std::nan(""), -30.5); }),
              HasSubstr("leaves the contact strip"));
}

namespace {

InfluenceFunction sample_table() {
  InfluenceFunction f = sample_function();
  f.table_dx = 0.5;
  for (int m = 0; m < 4; ++m)
    for (int a = 0; a < 9; ++a)
      for (int b = 0; b < 9; ++b) {
        const int sign = a < b ? parity(a % 3, b % 3) : 1;
        f.table.push_back(a == b ? 3e-6 / (1 + m) : sign * 1e-6 * std::cos(a * b + m) / (1 + a + b));
      }
  for (auto* kernel : {&f.wavenumber, &f.kernel, &f.remote, &f.remote_self})
    kernel->clear();
  return f;
}

} // namespace

TEST(InfluenceFile, APartIsTheWholeOnItsStations) {
  const TemporaryFolder folder;
  InfluenceFunction table = sample_function(12);
  table.table_dx = 0.5;
  for (int m = 0; m < 4; ++m)
    for (int row = 0; row < 36; ++row)
      for (int column = 0; column < 36; ++column) {
        const int low = std::min(row, column), high = std::max(row, column);
        const int sign = row < column ? parity(row % 3, column % 3) : 1;
        table.table.push_back(row == column ? 9.0 - m : sign * (0.01 * high + 1e-4 * low + m));
      }
  for (auto* all : {&table.wavenumber, &table.kernel, &table.remote, &table.remote_self})
    all->clear();
  for (const InfluenceFunction& whole : {sample_function(12), table}) {
    write_influence_file(folder / "a.h5", whole);
    InfluenceFile file(folder / "a.h5");
    for (const StationRange asked : {StationRange{6, 2}, {7, 1}, {3, 4}, {0, 12}}) {
      const InfluenceFunction& part = file.around(asked);
      const auto found = std::ranges::find(whole.stations, part.stations.front().s, &Station::s);
      const int first = static_cast<int>(found - whole.stations.begin()),
                count = static_cast<int>(part.stations.size());
      EXPECT_LE(first, asked.first);
      EXPECT_GE(first + count, asked.end());
      EXPECT_LE(count, asked.first == 6 || asked.first == 7 ? 4 : 12);
      const auto numbers = static_cast<std::size_t>(3 * count), skipped = static_cast<std::size_t>(3 * first);
      for (std::size_t row = 0; row < numbers; ++row)
        for (std::size_t column = 0; column < numbers; ++column) {
          for (std::size_t k = 0; k < whole.wavenumber_count(); ++k)
            ASSERT_EQ(part.kernel[part.kernel_index(k, row, column)],
                      whole.kernel[whole.kernel_index(k, row + skipped, column + skipped)]);
          for (std::size_t m = 0; m < whole.table_offsets(); ++m)
            ASSERT_EQ(part.table[(m * numbers + row) * numbers + column],
                      whole.table[(m * 36 + row + skipped) * 36 + column + skipped]);
        }
      for (std::size_t m = 0; m < 6 * whole.wavenumber_count(); ++m)
        for (std::size_t column = 0; column < numbers; ++column)
          ASSERT_EQ(part.remote[m * numbers + column], whole.remote[m * 36 + column + skipped]);
      EXPECT_EQ(part.remote_self, whole.remote_self);
    }
  }
}

TEST(InfluenceFile, HasNoMoreInMemoryThanWasAskedFor) {
  const TemporaryFolder folder;
  write_influence_file(folder / "a.h5", sample_function(60));
  InfluenceFile file(folder / "a.h5");
  const double strip = file.megabytes();
  file.around({30, 6});
  const double part = file.megabytes();
  file.around({32, 5}); // is there already
  EXPECT_EQ(file.megabytes(), part);
  file.around(file.strip().all_stations());
  EXPECT_LT(part - strip,
            0.06 * (file.megabytes() - strip)); // (6 + 6)^2 of 60^2 numbers, and of remote motions
}

TEST(InfluenceFile, PartsAreOfOneFile) {
  const TemporaryFolder folder;
  InfluenceFunction f = sample_function(12);
  const auto asks_on = [&](const auto& change) {
    write_influence_file(folder / "a.h5", sample_function(12));
    InfluenceFile file(folder / "a.h5");
    file.around({0, 1});
    change();
    return message_of([&] { file.around({10, 1}); });
  };
  EXPECT_EQ(asks_on([&] { write_influence_file(folder / "a.h5", f); }), "no error")
      << "the same numbers again";
  f.kernel.front() *= 2;
  EXPECT_THAT(asks_on([&] { write_influence_file(folder / "a.h5", f); }),
              AllOf(HasSubstr("is another one than before"), HasSubstr("Start again")));
  EXPECT_THAT(asks_on([&] { write_bytes(folder / "a.h5", text_of(folder / "a.h5") + "x"); }),
              HasSubstr("was altered"));
  EXPECT_THAT(asks_on([&] { std::filesystem::remove(folder / "a.h5"); }), HasSubstr("no such file"));
}

TEST(InfluenceFile, RefusesAKernelWhereItIsAskedFor) {
  const TemporaryFolder folder;
  write_influence_file(folder / "a.h5", sample_function(12));
  {
    const hid_t h5 = H5Fopen((folder / "a.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    const hid_t kernel = H5Dopen2(h5, "kernel", H5P_DEFAULT), space = H5Dget_space(kernel);
    const hsize_t last[] = {0, lower_size(36) - 1}, one[] = {1, 1};
    H5Sselect_hyperslab(space, H5S_SELECT_SET, last, nullptr, one, nullptr);
    const hid_t single = H5Screate_simple(2, one, nullptr);
    const double wrong = -1;
    EXPECT_GE(H5Dwrite(kernel, H5T_NATIVE_DOUBLE, single, space, H5P_DEFAULT, &wrong), 0);
    H5Sclose(single), H5Sclose(space), H5Dclose(kernel), H5Fclose(h5);
  }
  seal_again(folder / "a.h5");
  InfluenceFile file(folder / "a.h5");
  EXPECT_NO_THROW(file.around({0, 2}));
  EXPECT_THAT(message_of([&] { file.around({10, 2}); }), HasSubstr("diagonal is not positive"));
  EXPECT_THAT(reading(folder / "a.h5"), HasSubstr("diagonal is not positive"));
}

TEST(InfluenceFile, ReadsATableAsVersionOneOne) {
  const TemporaryFolder folder;
  const InfluenceFunction f = sample_table();
  write_influence_file(folder / "a.h5", f);
  const InfluenceFunction g = read_influence_file(folder / "a.h5");
  EXPECT_EQ(g.table_dx, f.table_dx);
  EXPECT_EQ(g.table, f.table);
  EXPECT_EQ(g.table_offsets(), 4u);
  EXPECT_TRUE(g.kernel.empty());
  EXPECT_THAT(text_of(folder / "a.h5"), HasSubstr("\nformat 1.1\n"));
  write_influence_file(folder / "b.h5", sample_function());
  EXPECT_THAT(text_of(folder / "b.h5"), HasSubstr("\nformat 1.0\n"));
}

TEST(InfluenceFile, RefusesTablesThatAreNone) {
  const auto refused = [](auto&& change) {
    InfluenceFunction f = sample_table();
    change(f);
    return message_of([&] { validate(f); });
  };
  EXPECT_THAT(refused([](auto& f) { f.table[1] += 1e-9; }), HasSubstr("its table is not reciprocal"));
  EXPECT_THAT(refused([](auto& f) { f.table[0] = 0; }), HasSubstr("diagonal is not positive"));
  EXPECT_THAT(refused([](auto& f) { f.table.pop_back(); }), HasSubstr("its table has the wrong size"));
  EXPECT_THAT(refused([](auto& f) { f.table[20] = NAN; }), HasSubstr("its table is not finite"));
  EXPECT_THAT(refused([](auto& f) { f.table_dx = 0; }), HasSubstr("its table has no element length"));
  EXPECT_THAT(refused([](auto& f) { f.table_dx = -1; }), HasSubstr("is not positive"));
  EXPECT_THAT(refused([](auto& f) { f.wavenumber = {0}; }), HasSubstr("both a kernel and a table"));
}
