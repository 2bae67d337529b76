#include "bem_contact/influence/lower_triangle.hpp"
#include "bem_contact/influence/partial_influence_file.hpp"
#include "sample_function.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <optional>

using namespace bem_contact;
using testing::HasSubstr;

namespace {

struct Computation {
  InfluenceFunction f = sample_function();
  TemporaryFolder folder;
  std::filesystem::path file = folder / "a.h5", part = folder / "a.h5.part";

  PartialInfluenceFile open(const std::string& fingerprint = "one run") const {
    return PartialInfluenceFile(file, fingerprint, f.station_count(), f.wavenumber);
  }
  void write(PartialInfluenceFile& partial, std::size_t k) const {
    std::vector<double> numbers;
    for (std::size_t a = 0; a < 9; ++a)
      for (std::size_t b = 0; b <= a; ++b)
        numbers.push_back(f.kernel[f.kernel_index(k, a, b)]);
    const std::span<const double> remote(f.remote), self(f.remote_self);
    for (const auto piece : {remote.subspan(54 * k, 54), self.subspan(36 * k, 36)})
      numbers.insert(numbers.end(), piece.begin(), piece.end());
    numbers.insert(numbers.end(), {double(k), -double(k)});
    partial.write(k, numbers);
  }
  int done(const PartialInfluenceFile& partial) const {
    int count = 0;
    for (std::size_t k = 0; k < f.wavenumber_count(); ++k)
      count += partial.has(k);
    return count;
  }
};

} // namespace

TEST(PartialFile, GoesOnWhereItStopped) {
  const Computation run;
  {
    PartialInfluenceFile partial = run.open();
    EXPECT_EQ(run.done(partial), 0);
    for (const std::size_t k : {3, 0, 7})
      run.write(partial, k);
  }
  PartialInfluenceFile partial = run.open();
  EXPECT_EQ(run.done(partial), 3);
  EXPECT_TRUE(partial.has(0) && partial.has(3) && partial.has(7));
  InfluenceFunction result = run.f;
  std::vector<double> errors;
  EXPECT_THAT(message_of([&] { partial.take_into(result, errors); }),
              testing::AllOf(HasSubstr("not complete"), HasSubstr("wavenumber 1 of 11")));
  for (std::size_t k = 0; k < run.f.wavenumber_count(); ++k)
    if (!partial.has(k))
      run.write(partial, k);
  partial.take_into(result, errors);
  EXPECT_EQ(result.kernel, run.f.kernel);
  EXPECT_EQ(result.remote, run.f.remote);
  EXPECT_EQ(result.remote_self, run.f.remote_self);
  ASSERT_EQ(errors.size(), 22u);
  for (std::size_t k = 0; k < 11; ++k)
    EXPECT_EQ(errors[2 * k], double(k));
  partial.remove();
  EXPECT_FALSE(std::filesystem::exists(run.part));
}

TEST(PartialFile, SurvivesAKillAtAnyByte) {
  const Computation run;
  {
    PartialInfluenceFile partial = run.open();
    for (const std::size_t k : {0, 1, 2})
      run.write(partial, k);
  }
  const auto whole = std::filesystem::file_size(run.part);
  const auto record = 16 + 8 * (45 + 54 + 36 + 2) + 64; // 45: a triangle of 9 x 9
  int least = 3;
  for (std::uintmax_t cut = 0; cut < whole; cut += 97) {
    std::filesystem::copy_file(run.part, run.folder / "keep",
                               std::filesystem::copy_options::overwrite_existing);
    std::filesystem::resize_file(run.part, whole - cut);
    {
      PartialInfluenceFile partial = run.open();
      const auto lost = static_cast<int>((cut + record - 1) / record);
      EXPECT_EQ(run.done(partial), std::max(0, 3 - lost)) << cut;
      least = std::min(least, run.done(partial));
      run.write(partial, 5);
    }
    const PartialInfluenceFile again = run.open(); // what follows a cut is whole
    EXPECT_TRUE(again.has(5)) << cut;
    std::filesystem::copy_file(run.folder / "keep", run.part,
                               std::filesystem::copy_options::overwrite_existing);
  }
  EXPECT_EQ(least, 0);
}

TEST(PartialFile, AnAlteredRecordIsNotTakenOver) {
  const Computation run;
  {
    PartialInfluenceFile partial = run.open();
    run.write(partial, 0);
    run.write(partial, 1);
  }
  std::fstream file(run.part, std::ios::binary | std::ios::in | std::ios::out);
  file.seekp(-500, std::ios::end);
  file.put('?');
  file.close();
  const PartialInfluenceFile partial = run.open();
  EXPECT_TRUE(partial.has(0));
  EXPECT_FALSE(partial.has(1));
}

TEST(PartialFile, AnotherRunIsRefusedAndLosesNothing) {
  Computation run;
  {
    PartialInfluenceFile partial = run.open();
    run.write(partial, 4);
  }
  EXPECT_THAT(message_of([&] { run.open("another run"); }),
              testing::AllOf(HasSubstr("another body"), HasSubstr("a.h5.part"), HasSubstr("another output")));
  {
    const PartialInfluenceFile partial = run.open();
    EXPECT_TRUE(partial.has(4));
  }
  run.f.wavenumber.back() += 1;
  EXPECT_THAT(message_of([&] { run.open(); }), HasSubstr("another body"));
}

TEST(PartialFile, AnotherRunTakesAFileWithNothingFinished) {
  const Computation run;
  EXPECT_EQ(run.done(run.open()), 0);
  PartialInfluenceFile other = run.open("another run, with a longer name");
  run.write(other, 2);
  EXPECT_EQ(run.done(other), 1);
}

TEST(PartialFile, HasOneWriter) {
  const Computation run;
  const PartialInfluenceFile first = run.open();
  EXPECT_THAT(message_of([&] { run.open(); }), HasSubstr("a.h5.part' is in use"));
}

TEST(PartialFile, AStrangersFileIsNotWrittenOver) {
  const Computation run;
  std::ofstream(run.part) << "my notes";
  EXPECT_THAT(message_of([&] { run.open(); }), HasSubstr("no finished wavenumbers"));
  EXPECT_EQ(std::filesystem::file_size(run.part), 8u);
}

TEST(LowerTriangle, SymmetricMatricesOfAnySizeComeBack) {
  for (const std::size_t n : {1, 31, 32, 33, 100}) { // tiles are 32 wide
    std::vector<double> matrix(n * n), lower, again(n * n, -1.0);
    for (std::size_t row = 0; row < n; ++row)
      for (std::size_t column = 0; column < n; ++column)
        matrix[row * n + column] = static_cast<double>(std::min(row, column) * 1000 + std::max(row, column));
    append_lower(lower, matrix, n);
    EXPECT_EQ(lower.size(), lower_size(n));
    fill_symmetric(again, lower, n);
    EXPECT_EQ(again, matrix) << n;
    std::size_t visited = 0;
    for_each_below_diagonal(n, [&](std::size_t row, std::size_t column) { visited += column < row; });
    EXPECT_EQ(visited, lower_size(n) - n);
  }
}

TEST(PartialFile, SaysWhereItCannotWrite) {
  const Computation run;
  EXPECT_THAT(message_of([&] {
                PartialInfluenceFile(run.folder / "none" / "a.h5", "x", run.f.station_count(),
                                     run.f.wavenumber);
              }),
              HasSubstr("cannot be written"));
  PartialInfluenceFile partial = run.open();
  EXPECT_THROW(partial.write(0, {}), Error);
}
