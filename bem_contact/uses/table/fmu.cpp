#include "bem_contact/uses/table/fmu.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/provenance.hpp"
#include "bem_contact/base/sha256.hpp"
#include "bem_contact/uses/table/packed_table.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <string_view>

namespace bem_contact::table {

// The headers of the folder fmu; the build writes them.
extern const char* const fmu_functions;
extern const char* const fmu_state_functions;
extern const char* const fmi2_functions;
extern const char* const fmi3_functions;

namespace {

/// A unit of tables as FMI has it: a product of powers of base units, times a factor.
struct FmuUnit {
  std::string_view name; ///< in tables
  std::string_view own;  ///< the same by FMI's rules: a dot between factors
  std::string_view si;
  int kg, m, s, rad; ///< powers
  double factor;     ///< one of it in SI
};
constexpr FmuUnit units[] = {
    {"1", "1", "1", 0, 0, 0, 0, 1},          {"mm", "mm", "m", 0, 1, 0, 0, 1e-3},
    {"rad", "rad", "rad", 0, 0, 0, 1, 1},    {"1/mm", "1/mm", "1/m", 0, -1, 0, 0, 1e3},
    {"N", "N", "N", 1, 1, -2, 0, 1},         {"N mm", "N.mm", "N.m", 1, 2, -2, 0, 1e-3},
    {"MPa", "MPa", "Pa", 1, -1, -2, 0, 1e6}, {"mm2", "mm2", "m2", 0, 2, 0, 0, 1e-6},
    {"s", "s", "s", 0, 0, 1, 0, 1},          {"mm/s", "mm/s", "m/s", 0, 1, -1, 0, 1e-3},
};

/// A number that goes in or out.
struct Variable {
  std::string name, unit, description, causality; ///< unit: of the table
  double from = 0, to = 0;                        ///< of an input, in that unit
  double value = 0;                               ///< start of an input, or a constant, in that unit
};

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text)
    switch (c) {
    case '&':
      out += "&amp;";
      break;
    case '<':
      out += "&lt;";
      break;
    case '>':
      out += "&gt;";
      break;
    case '"':
      out += "&quot;";
      break;
    default:
      out += c;
    }
  return out;
}

class Writer {
public:
  Writer(const ContactTable& table, const FmuOptions& options) : options_(options) {
    for (const Axis& axis : table.axes)
      variables_.push_back({axis.name, axis.unit,
                            fmt::format("{}, from {:g} to {:g}{}", axis.description, axis.from(), axis.to(),
                                        axis.unit == "1" ? "" : " " + axis.unit),
                            "input", axis.from(), axis.to(),
                            axis.from() <= 0 && axis.to() >= 0 ? 0 : 0.5 * (axis.from() + axis.to())});
    for (const Column& column : table.columns)
      if (options.columns.empty())
        columns_.push_back(&column);
    for (const std::string& name : options.columns)
      columns_.push_back(&table.column(name));
    for (const Column* column : columns_)
      variables_.push_back({column->name, column->unit, column->description, "output"});
    variables_.push_back(
        {"margin", "1",
         "distance from the nearest end of an axis, over its length; below 0 outside, where there "
         "are no forces",
         "output"});
    for (const Column* column : columns_)
      variables_.push_back(
          {column->name + "_error", column->unit,
           fmt::format("stated error of {}, between the points and by the elements", column->name), "local",
           0, 0, column->error()});
    packed_ = packed_source(table, options.columns);
    token_ = sha256(fmt::format("{}\n{}\n{}", packed_, options.model, options.si));
  }

  std::string source() const {
    std::string out =
        fmt::format("/* Forces of contact between wheel and rail, as an FMU. Written by {}. */\n{}\n"
                    "#define CONFORMAL_FMU_AXES {}\n#define CONFORMAL_FMU_COLUMNS {}\n"
                    "#define CONFORMAL_FMU_TOKEN \"{}\"\n",
                    provenance("bem_contact"), packed_, axes(), columns_.size(), token_);
    const auto print = [&](const char* name, std::size_t first, std::size_t count, const auto& number) {
      std::vector<double> numbers;
      for (std::size_t i = 0; i < count; ++i)
        numbers.push_back(number(variables_[first + i]));
      fmt::format_to(std::back_inserter(out), "static const double {}[] = {{{:.17g}}};\n", name,
                     fmt::join(numbers, ", "));
    };
    const auto factor = [this](const Variable& v) { return in_table_units(v, 1); };
    print("conformal_fmu_start", 0, axes(), [this](const Variable& v) { return in_table_units(v, v.value); });
    print("conformal_fmu_input_unit", 0, axes(), factor);
    print("conformal_fmu_output_unit", axes(), columns_.size(), factor);
    return fmt::format("{}\n{}\n{}\n{}\n{}", out, fmu_functions, fmu_state_functions, fmi3_functions,
                       fmi2_functions);
  }

  std::string description() const {
    const bool v2 = options_.version == FmiVersion::v2;
    std::string out = fmt::format(
        R"(<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription fmiVersion="{}" modelName="{}" {}="{}" description="Forces of contact between wheel and rail, looked up in a table" generationTool="{}" variableNamingConvention="structured"{}>
)",
        v2 ? "2.0" : "3.0", options_.model, v2 ? "guid" : "instantiationToken", token_,
        escaped(provenance("bem_contact")), v2 ? " numberOfEventIndicators=\"0\"" : "");
    out += v2 ? interface2("ModelExchange", "") +
                    interface2("CoSimulation", " canHandleVariableCommunicationStepSize=\"true\"")
              : interface3("ModelExchange") +
                    interface3("CoSimulation", " canHandleVariableCommunicationStepSize=\"true\"");
    out += "  <UnitDefinitions>\n" + unit_definitions() + "  </UnitDefinitions>\n";
    out += "  <LogCategories>\n    <Category name=\"logStatusError\" description=\"calls that are "
           "wrong\"/>\n    <Category "
           "name=\"logStatusDiscard\" description=\"inputs outside of the table\"/>\n  </LogCategories>\n";
    out += "  <ModelVariables>\n" + variable("time", 0, "independent", v2, unit_named("s"), "");
    for (std::size_t i = 0; i < variables_.size(); ++i)
      out += variable(variables_[i], i + 1, v2);
    out += "  </ModelVariables>\n  <ModelStructure>\n" + (v2 ? structure2() : structure3());
    return out + "  </ModelStructure>\n</fmiModelDescription>\n";
  }

  std::string build_description() const {
    if (options_.version == FmiVersion::v2)
      return "";
    return fmt::format(R"(<?xml version="1.0" encoding="UTF-8"?>
<fmiBuildDescription fmiVersion="3.0">
  <BuildConfiguration modelIdentifier="{0}">
    <SourceFileSet language="C99">
      <SourceFile name="{0}.c"/>
    </SourceFileSet>
  </BuildConfiguration>
</fmiBuildDescription>
)",
                       options_.model);
  }

private:
  std::size_t axes() const { return variables_.size() - 2 * columns_.size() - 1; }

  static const FmuUnit* unit_named(std::string_view name) {
    const auto found = std::ranges::find(units, name, &FmuUnit::name);
    return found == std::end(units) ? nullptr : found;
  }
  std::string_view name_of(const FmuUnit& unit) const { return options_.si ? unit.si : unit.own; }
  /// A number of the table in units of the FMU.
  double in_table_units(const Variable& v, double value) const {
    const FmuUnit* unit = unit_named(v.unit);
    return options_.si && unit ? value * unit->factor : value;
  }

  std::string interface2(const char* name, const char* more) const {
    return fmt::format("  <{0} modelIdentifier=\"{1}\"{2} canNotUseMemoryManagementFunctions=\"true\" "
                       "canGetAndSetFMUstate=\"true\" canSerializeFMUstate=\"true\" "
                       "providesDirectionalDerivative=\"true\">\n    <SourceFiles>\n      <File "
                       "name=\"{1}.c\"/>\n    </SourceFiles>\n  </{0}>\n",
                       name, options_.model, more);
  }
  std::string interface3(const char* name, const char* more = "") const {
    return fmt::format(
        "  <{} modelIdentifier=\"{}\"{} canGetAndSetFMUState=\"true\" canSerializeFMUState=\"true\" "
        "providesDirectionalDerivatives=\"true\" providesAdjointDerivatives=\"true\"/>\n",
        name, options_.model, more);
  }

  std::string unit_definitions() const {
    std::string out;
    for (const FmuUnit& unit : units)
      if (unit.name == "s" || std::ranges::find(variables_, unit.name, &Variable::unit) != variables_.end()) {
        fmt::format_to(std::back_inserter(out), "    <Unit name=\"{}\">\n      <BaseUnit", name_of(unit));
        for (const auto& [name, power] :
             {std::pair{"kg", unit.kg}, {"m", unit.m}, {"s", unit.s}, {"rad", unit.rad}})
          if (power != 0)
            fmt::format_to(std::back_inserter(out), " {}=\"{}\"", name, power);
        if (!options_.si && unit.factor != 1)
          fmt::format_to(std::back_inserter(out), " factor=\"{}\"", unit.factor);
        out += "/>\n    </Unit>\n";
      }
    return out;
  }

  /// `more`: attributes of its number.
  std::string variable(std::string_view name, std::size_t reference, std::string_view causality, bool v2,
                       const FmuUnit* unit, std::string_view description, std::string_view more = "") const {
    const std::string_view variability = causality == "local" ? "constant" : "continuous";
    const std::string_view initial = causality == "local"    ? " initial=\"exact\""
                                     : causality == "output" ? " initial=\"calculated\""
                                                             : "";
    const std::string head =
        fmt::format("name=\"{}\" valueReference=\"{}\" causality=\"{}\" variability=\"{}\"{}{}", name,
                    reference, causality, variability, initial,
                    description.empty() ? "" : fmt::format(" description=\"{}\"", escaped(description)));
    const std::string number = (unit ? fmt::format(" unit=\"{}\"", name_of(*unit)) : "") + std::string(more);
    return v2 ? fmt::format("    <ScalarVariable {}>\n      <Real{}/>\n    </ScalarVariable>\n", head, number)
              : fmt::format("    <Float64 {}{}/>\n", head, number);
  }
  std::string variable(const Variable& v, std::size_t reference, bool v2) const {
    if (v.causality == "local" && !std::isfinite(v.value))
      return ""; // an error that is not known
    std::string more;
    if (v.causality == "input")
      more =
          fmt::format(" min=\"{:.17g}\" max=\"{:.17g}\"", in_table_units(v, v.from), in_table_units(v, v.to));
    if (v.causality != "output")
      more += fmt::format(" start=\"{:.17g}\"", in_table_units(v, v.value));
    return variable(v.name, reference, v.causality, v2, unit_named(v.unit), v.description, more);
  }

  /// Each output, by what it depends on: all inputs.
  std::string unknowns(const char* element, const char* naming, std::size_t base) const {
    std::vector<std::size_t> inputs;
    for (std::size_t a = 0; a < axes(); ++a)
      inputs.push_back(1 + a + base);
    std::string out;
    for (std::size_t c = 0; c <= columns_.size(); ++c)
      fmt::format_to(std::back_inserter(out), "    <{} {}=\"{}\" dependencies=\"{}\"/>\n", element, naming,
                     1 + axes() + c + base, fmt::join(inputs, " "));
    return out;
  }
  std::string structure3() const {
    return unknowns("Output", "valueReference", 0) + unknowns("InitialUnknown", "valueReference", 0);
  }
  /// Variables count from 1 there.
  std::string structure2() const {
    return "    <Outputs>\n" + unknowns("Unknown", "index", 1) + "    </Outputs>\n    <InitialUnknowns>\n" +
           unknowns("Unknown", "index", 1) + "    </InitialUnknowns>\n";
  }

  const FmuOptions& options_;
  std::vector<const Column*> columns_;
  std::vector<Variable> variables_; ///< in the order of their value references, from 1
  std::string packed_, token_;
};

void require_name(const std::string& name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  const bool good = !name.empty() && letter(name.front()) &&
                    std::ranges::all_of(name, [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
  if (!good)
    throw InputError(fmt::format("'{}' cannot name an FMU", name),
                     "it is no name of C: letters, digits and _, and no digit first",
                     "Give another with --name, such as contact.");
}

} // namespace

Fmu fmu_of(const ContactTable& table, const FmuOptions& options) {
  require_name(options.model);
  const Writer writer(table, options);
  return {options.model, writer.description(), writer.build_description(), writer.source()};
}

} // namespace bem_contact::table
