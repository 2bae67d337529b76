#include "bem_contact/sequence/numbers/pair_numbers.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/halfspace/combine.hpp"
#include "bem_contact/halfspace/flat_strip.hpp"
#include "bem_contact/halfspace/resample.hpp"
#include "bem_contact/halfspace/tangent_plane.hpp"
#include "bem_contact/influence/influence_file.hpp"
#include "bem_contact/influence/requirements.hpp"
#include "bem_contact/sequence/numbers/add_wheel.hpp"
#include "bem_contact/sequence/numbers/section_blend.hpp"
#include "bem_contact/sequence/numbers/settings.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <utility>

namespace bem_contact {

namespace {

/// rad. How far the surface of a rail's file may turn otherwise than a patch.
constexpr double rail_turn_tolerance = 0.02;
/// rad. The same for the wheel's, whose surface need not follow the rail's.
constexpr double wheel_turn_tolerance = 0.2;

/// An error about a section's file names the section.
template <class Read> auto of_section(const SectionInfluence& section, const Read& read) {
  try {
    return read();
  } catch (const InputError& error) {
    throw InputError(fmt::format("Influence file of {}: {}", section_in_words(section), error.what()));
  }
}

std::vector<std::shared_ptr<InfluenceFile>> read_sections(const Body& rail) {
  std::map<std::filesystem::path, std::shared_ptr<InfluenceFile>> known;
  std::vector<std::shared_ptr<InfluenceFile>> out;
  for (const SectionInfluence& section : rail.sections)
    out.push_back(of_section(section, [&] {
      std::shared_ptr<InfluenceFile>& file = known[section.file];
      if (!file)
        file = std::make_shared<InfluenceFile>(section.file);
      require_material(file->strip(), rail.material);
      require_profile(file->strip(), section.profile, section.digest);
      if (file->strip().invariance != Invariance::prismatic)
        throw InputError("it is that of a body of revolution", "a rail is the same along the track",
                         "Compute the functions of the rail, without body.roller_radius.");
      return file;
    }));
  return out;
}

std::shared_ptr<InfluenceFile> read_side(const Body& body) {
  if (body.influence.empty())
    return nullptr;
  auto file = std::make_shared<InfluenceFile>(body.influence);
  require_material(file->strip(), body.material);
  return file;
}

bool on_strip(const InfluenceFile& file, double s, double ds) {
  const auto [from, to] = file.strip().ends();
  return s - row_on_strip * ds >= from && s + row_on_strip * ds <= to;
}

ExpandOptions options_of(const InfluenceStrip& strip, const Body& body, const ContactOnGrid& contact,
                         double contact_radius, NumbersParts* known, int threads) {
  const ContactGrid& grid = contact.problem.grid;
  const bool plane_strain = contact.problem.plane_strain();
  ExpandOptions options;
  options.dx = plane_strain ? 0.0 : grid.dx;
  options.offsets = plane_strain ? 1 : grid.mx + 2;
  options.structural = body.structural;
  options.series = known ? &known->series : nullptr;
  options.threads = threads;
  options.contact_radius = strip.invariance == Invariance::revolution ? contact_radius : 0.0;
  return options;
}

/// Steady rolling of turning bodies, where points of a surface that have moved off the axis are faster.
bool slips_with_radial_displacement(const ContactSetup& setup) {
  const Motion& motion = setup.motion;
  return setup.wheel_rail() && motion.tangential && motion.kind == MotionKind::steady &&
         motion.radial_displacement;
}

/// Of each row against an axis that is turned by `axis` from y of the track, rad.
std::vector<double> inclinations(const std::vector<ContactRow>& rows, double axis) {
  std::vector<double> all;
  for (const ContactRow& row : rows)
    all.push_back(row.delta - axis);
  return all;
}

/// The function where rows at these arc lengths need it.
const InfluenceFunction& function_at(InfluenceFile& file, const std::vector<double>& row_s) {
  return file.around(halfspace::stations_under(file.strip(), row_s));
}

InfluenceNumbers rail_numbers(const std::shared_ptr<InfluenceFile>& file, const ContactSetup& setup,
                              const ContactOnGrid& contact, NumbersParts* known, int threads) {
  const ContactGrid& grid = contact.problem.grid;
  const Body& body = setup.rail;
  const double radius = contact.roller_contact_radius;
  const auto compute = [&] {
    return halfspace::resample(function_at(*file, contact.rail_s),
                               options_of(file->strip(), body, contact, radius, known, threads),
                               contact.rail_s, grid.ds, known ? &known->lines : nullptr);
  };
  if (radius > 0) {
    InfluenceNumbers numbers = compute();
    if (slips_with_radial_displacement(setup))
      add_radial_displacement(inclinations(contact.problem.rows, 0), radius, numbers);
    return numbers;
  }
  if (!known || contact.problem.plane_strain() || file->strip().invariance == Invariance::revolution)
    return compute();
  return known->rail.get({file, body.structural, grid.dx, grid.ds}, contact.rail_s, grid.mx + 2, compute);
}

/// The numbers of a part of the rows, into the table of all of them; rows of other parts feel nothing of it.
void add_block(const InfluenceNumbers& part, double weight, int first, InfluenceNumbers& all) {
  for (int m = 0; m < all.offsets; ++m)
    for (int row_i = 0; row_i < part.rows; ++row_i)
      for (int row_j = 0; row_j < part.rows; ++row_j)
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            all.at(m, first + row_i, i, first + row_j, j) += weight * part.at(m, row_i, i, row_j, j);
}

std::vector<double> shifted(const std::vector<double>& s, const SectionBlend::Stretch& stretch, double by) {
  std::vector<double> out(s.begin() + stretch.first, s.begin() + stretch.first + stretch.rows);
  for (double& one : out)
    one += by;
  return out;
}

/// The numbers of a rail of sections (section_blend()).
InfluenceNumbers sectioned_rail_numbers(const PairFiles& files, const ContactSetup& setup,
                                        const ContactOnGrid& contact, NumbersParts* known, int threads) {
  const ContactGrid& grid = contact.problem.grid;
  InfluenceNumbers out{grid.mx + 2, grid.ms, grid.dx, grid.ds, {}};
  out.values.resize(out.expected_values());
  std::ranges::fill(out.values, 0.0);
  halfspace::LineStore* lines = known ? &known->lines : nullptr;
  const RowsOnBodies rows{contact.problem.rows, contact.rail_s, contact.wheel_s};
  for (const SectionBlend::Stretch& stretch : blend_on_strips(setup, files, rows, grid.ds).stretches) {
    if (stretch.parts.empty()) // never loaded: the numbers are positive, and that is all
      add_block(halfspace::influence_numbers(setup.rail.material, grid.dx, grid.ds, out.offsets, stretch.rows,
                                             lines),
                1, stretch.first, out); // translational: at() has all pairs
    for (const SectionBlend::Part& part : stretch.parts) {
      const std::vector<double> s = shifted(contact.rail_s, stretch, part.shift);
      InfluenceFile& file = *files.sections[part.file];
      add_block(halfspace::resample(function_at(file, s),
                                    options_of(file.strip(), setup.rail, contact, 0, known, threads), s,
                                    grid.ds, lines),
                part.weight, stretch.first, out);
    }
  }
  return out;
}

/// A patch is given without profiles: what can be compared is how far the normal turns along the strip.
/// Throws InputError where the file's surface turns otherwise than the rows do, by more than `tolerance`.
void require_turn(const InfluenceStrip& f, const ContactOnGrid& contact, const std::vector<double>& row_s,
                  double tolerance) {
  const std::vector<ContactRow>& rows = contact.problem.rows;
  const std::size_t middle = rows.size() / 2;
  const double station =
      std::abs(f.stations.back().delta - f.stations.front().delta) / static_cast<double>(f.stations.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double file_turn = f.nearest_station(row_s[i]).delta - f.nearest_station(row_s[middle]).delta;
    const double row_turn = rows[i].delta - rows[middle].delta;
    if (std::abs(file_turn - row_turn) > tolerance + station)
      throw InputError(
          fmt::format("The influence functions of '{}' do not fit the patch", f.body),
          fmt::format("from the middle to row {} their surface turns by {:.3f} rad and the patch by "
                      "{:.3f} rad",
                      i, file_turn, row_turn),
          "Correct [strip] (radius, inclination, rail_s0, wheel_s0) or give the bodies' own files.");
  }
}

/// The same numbers with the rows in the opposite order.
InfluenceNumbers reversed(const InfluenceNumbers& numbers) {
  InfluenceNumbers out = numbers;
  const int last = numbers.rows - 1;
  for (int m = 0; m < numbers.offsets; ++m)
    for (const auto& [row_i, row_j] : numbers.stored_rows())
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          out.at(m, row_i, i, row_j, j) = numbers.at(m, last - row_i, i, last - row_j, j);
  return out;
}

} // namespace

PairFiles read_pair_files(const Body& rail, const Body& wheel) {
  PairFiles files{read_side(rail), read_side(wheel), read_sections(rail)};
  if (files.complete())
    require_order((files.rail ? files.rail : files.sections.front())->strip(), files.wheel->strip());
  return files;
}

std::vector<std::shared_ptr<InfluenceFile>> PairFiles::all() const {
  std::vector<std::shared_ptr<InfluenceFile>> out = sections;
  for (const auto& file : {rail, wheel})
    if (file)
      out.push_back(file);
  return out;
}

InfluenceNumbers halfspace_pair(const ContactSetup& setup, const ContactOnGrid& contact,
                                NumbersParts* known) {
  const ContactGrid& grid = contact.problem.grid;
  const auto one = [&](const Material& material) {
    // On a curved strip forces depend on the reference distance of plane strain, since the approach turns
    // with the normal; the strip's radius is what the disc in a hole has (Michell 1899).
    return contact.problem.plane_strain()
               ? halfspace::plane_strain_numbers(material, grid.ds, grid.ms, setup.reference_distance())
               : halfspace::influence_numbers(material, grid.dx, grid.ds, grid.mx + 2, grid.ms,
                                              known ? &known->lines : nullptr);
  };
  // The wheel's own s runs against the rail's: with rows in the contact's order the couplings of equal bodies
  // cancel.
  const Material &below = setup.rail.material, &above = setup.wheel.material;
  InfluenceNumbers rail = one(below);
  if (above == below && rail.translational)
    return halfspace::combine_equal(std::move(rail));
  return halfspace::combine(rail, reversed(above == below ? rail : one(above)));
}

InfluenceNumbers tangent_plane_pair(const ContactSetup& setup, const ContactOnGrid& contact,
                                    NumbersParts* known) {
  const ContactGrid& grid = contact.problem.grid;
  const bool plane_strain = contact.problem.plane_strain();
  std::vector<ContactRow> wheel = contact.problem.rows; // the wheel's own frame is turned by pi about x
  for (ContactRow& row : wheel)
    row.position = -1.0 * row.position;
  const halfspace::StripGrid strip{plane_strain ? 0.0 : grid.dx, grid.ds, plane_strain ? 1 : grid.mx + 2,
                                   setup.reference_distance()};
  halfspace::LineStore of_this_pair;
  halfspace::LineStore& lines = known ? known->lines : of_this_pair;
  return halfspace::combine(
      halfspace::tangent_plane_numbers(setup.rail.material, strip, contact.problem.rows, &lines),
      halfspace::tangent_plane_numbers(setup.wheel.material, strip, wheel, &lines));
}

InfluenceNumbers fem_pair(const ContactSetup& setup, const PairFiles& files, const ContactOnGrid& contact,
                          NumbersParts* known, int threads) {
  if (!files.complete())
    throw InputError("The finite-element model needs influence functions of both bodies",
                     !files.of_rail() && !files.wheel ? "the scene names none"
                     : files.of_rail()                ? "the scene names none for the wheel"
                                                      : "the scene names none for the rail",
                     "Give rail.influence and wheel.influence, or name other models, such as halfspace and "
                     "tangent_plane.");
  const double ds = contact.problem.grid.ds;
  require_strips(rows_on_files(setup, files, {contact.problem.rows, contact.rail_s, contact.wheel_s}, ds),
                 ds);
  if (setup.patch()) {
    require_turn(files.rail->strip(), contact, contact.rail_s, rail_turn_tolerance);
    require_turn(files.wheel->strip(), contact, contact.wheel_s, wheel_turn_tolerance);
  }
  InfluenceNumbers pair = files.rail ? rail_numbers(files.rail, setup, contact, known, threads)
                                     : sectioned_rail_numbers(files, setup, contact, known, threads);
  const std::vector<double> inclination = radial_inclination(setup, contact.problem.rows);
  halfspace::resample_lines(
      function_at(*files.wheel, contact.wheel_s),
      options_of(files.wheel->strip(), setup.wheel, contact, contact.contact_radius, known, threads),
      contact.wheel_s, pair.ds,
      [&](NumberLines& lines) { add_wheel(lines, inclination, contact.contact_radius, pair); },
      known ? &known->lines : nullptr);
  return pair;
}

std::vector<double> radial_inclination(const ContactSetup& setup, const std::vector<ContactRow>& rows) {
  return slips_with_radial_displacement(setup) ? inclinations(rows, setup.wheel_rail()->pair.wheel_pose.angle)
                                               : std::vector<double>{};
}

std::vector<RowsOnStrip> rows_on_files(const ContactSetup& setup, const PairFiles& files,
                                       const RowsOnBodies& rows, double ds) {
  std::vector<RowsOnStrip> out;
  if (files.rail && !rows.rail_s.empty())
    out.push_back({files.rail, 0, rows.rail_s});
  if (!files.sections.empty() && !rows.rows.empty())
    for (const SectionBlend::Stretch& stretch : blend_on_strips(setup, files, rows, ds).stretches)
      for (const SectionBlend::Part& part : stretch.parts)
        out.push_back({files.sections[part.file], stretch.first, shifted(rows.rail_s, stretch, part.shift),
                       section_in_words(setup.rail.sections[part.file])});
  if (files.wheel && !rows.wheel_s.empty())
    out.push_back({files.wheel, 0, rows.wheel_s});
  return out;
}

SectionBlend blend_on_strips(const ContactSetup& setup, const PairFiles& files, const RowsOnBodies& rows,
                             double ds) {
  SectionBlend out = section_blend(setup, rows.rows);
  const auto is_gap = [&](std::size_t i) {
    return i < out.stretches.size() && out.stretches[i].parts.empty();
  };
  for (std::size_t i = 0; i < out.stretches.size(); ++i) {
    SectionBlend::Stretch& stretch = out.stretches[i];
    const auto off = [&](int row) {
      return std::ranges::any_of(stretch.parts, [&](const SectionBlend::Part& part) {
        return !on_strip(*files.sections[part.file], rows.rail_s[row] + part.shift, ds);
      });
    };
    for (; i > 0 && is_gap(i - 1) && stretch.rows > 1 && off(stretch.first); --stretch.rows, ++stretch.first)
      ++out.stretches[i - 1].rows;
    for (; is_gap(i + 1) && stretch.rows > 1 && off(stretch.first + stretch.rows - 1); --stretch.rows) {
      --out.stretches[i + 1].first;
      ++out.stretches[i + 1].rows;
    }
  }
  return out;
}

void require_strips(const std::vector<RowsOnStrip>& strips, double ds) {
  const double half = row_on_strip * ds;
  for (const RowsOnStrip& rows : strips) {
    const auto [lo, hi] = std::ranges::minmax(rows.s);
    try {
      require_strip(rows.file->strip(), lo - half, hi + half);
    } catch (const OffStripError& error) {
      if (rows.section.empty())
        throw;
      throw OffStripError(fmt::format("Influence file of {}: {}", rows.section, error.what()));
    }
  }
}

std::pair<int, int> covered_rows(const std::vector<RowsOnStrip>& strips, double ds, int rows) {
  std::vector<char> good(rows, 1);
  for (const RowsOnStrip& on : strips)
    for (std::size_t i = 0; i < on.s.size(); ++i)
      good[on.first + i] = good[on.first + i] && on_strip(*on.file, on.s[i], ds);
  const auto first = std::ranges::find(good, 1);
  const auto last = std::find(good.rbegin(), good.rend(), 1);
  return {static_cast<int>(first - good.begin()), static_cast<int>(good.rend() - last) - 1};
}

} // namespace bem_contact
