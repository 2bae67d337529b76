#include "bem_contact/app/output/output_names.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/hdf5.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <system_error>

namespace bem_contact::app {

namespace {

void require_ending(const Output& output, const char* what, std::vector<std::string> own) {
  constexpr const char* of_other_files[] = {".h5",  ".hdf5", ".csv", ".json", ".txt", ".toml", ".html",
                                            ".png", ".pdf",  ".svg", ".vtk",  ".vts", ".vtu",  ".xlsx"};
  const std::string ending = lower_ending(output.file);
  if (std::ranges::count(own, ending) == 0 && std::ranges::count(of_other_files, ending) > 0)
    throw InputError(
        fmt::format("'{}' of {} would have a misleading name", output.file.string(), output.option),
        fmt::format("what is written is {}", what),
        fmt::format("Give a name that ends with {}.", own.front()));
}

/// "": there is nothing, or nothing in it. HDF5 of others has another format, or none.
std::optional<std::string> format_there(const std::filesystem::path& file) {
  std::error_code unknown;
  if (!is_regular(file) || std::filesystem::file_size(file, unknown) == 0)
    return std::nullopt;
  return record::format_of(file);
}

[[noreturn]] void refuse_replacing(const std::filesystem::path& file, const std::string& why) {
  throw InputError(fmt::format("The file '{}' exists and would be replaced", file.string()), why,
                   "Give another output, or remove the file.");
}

/// A file of ours may be made again; one that somebody else made is kept.
void require_own_file(const std::filesystem::path& file) {
  if (const auto format = format_there(file); format && !kind_of(*format))
    refuse_replacing(file, "bem_contact did not make it");
}

} // namespace

void require_replaceable(const std::filesystem::path& output, std::string_view format,
                         std::string_view holds) {
  if (const auto there = format_there(output); there && kind_of(*there) != kind_of(format))
    refuse_replacing(output, fmt::format("it does not hold {}", holds));
}

void require_page_name(const Output& output) {
  require_ending(output, "a page (HTML)", {".html"});
}

void require_named_outputs(const std::vector<std::filesystem::path>& inputs,
                           const std::vector<Output>& outputs) {
  require_outputs(inputs, outputs);
  for (const Output& output : outputs)
    if (output.form == OutputForm::whole_file) {
      require_ending(output, "an HDF5 file", {".h5", ".hdf5"});
      require_own_file(output.file);
    } else if (output.option == "--vtk")
      require_ending(output, "a surface for ParaView in XML", {".vts"});
    else if (output.option == "--vtu")
      require_ending(output, "a grid for ParaView in XML", {".vtu"});
    else if (output.option == "--csv")
      require_ending(output, "a table in CSV", {".csv", ".txt"});
    else if (output.option == "--plot")
      require_page_name(output);
}

GivenScene read_given_scene_for(const std::vector<Output>& outputs, const std::string& file,
                                const std::string& model) {
  GivenScene out = read_given_scene(file, model);
  require_named_outputs(files_read(file, out.scene), outputs);
  if (std::ranges::any_of(outputs, [](const Output& output) {
        return output.form == OutputForm::whole_file && !output.file.empty();
      }))
    out.inputs = inputs_of(out.scene);
  return out;
}

} // namespace bem_contact::app
