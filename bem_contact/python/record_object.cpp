#include "bem_contact/python/record_object.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cmath>

namespace py = pybind11;

namespace bem_contact {

namespace {

py::object number(double value, bool whole) {
  if (std::isnan(value))
    return py::none();
  return whole ? py::object(py::int_(static_cast<long long>(value))) : py::object(py::float_(value));
}

py::array_t<double> array(std::span<const double> values) {
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

struct AsObject {
  py::object operator()(std::monostate) const { return py::none(); }
  py::object operator()(bool flag) const { return py::bool_(flag); }
  py::object operator()(const record::Number& n) const { return number(n.value, n.whole); }
  py::object operator()(const record::Text& text) const { return py::str(text.text); }
  py::object operator()(const record::Texts& texts) const { return py::cast(texts.lines); }
  py::object operator()(const record::Field& field) const {
    return py::array_t<double>(field.shape, field.values.data());
  }
  py::object operator()(const record::Table& table) const {
    if (table.layout == record::Layout::columns)
      return columns_of(table);
    py::list rows;
    for (std::size_t row = 0; row < table.size(); ++row) {
      py::dict one;
      for (const record::Column& column : table.columns)
        one[column.name.c_str()] = number(column.values[row], column.whole);
      rows.append(one);
    }
    return rows;
  }
  py::object operator()(const record::Record& record) const { return as_dict(record); }
};

} // namespace

py::object as_object(const record::Content& content) {
  return std::visit(AsObject{}, content);
}

py::dict as_dict(const record::Record& record) {
  py::dict out;
  for (const record::Entry& entry : record.entries()) {
    out[entry.name.c_str()] = as_object(entry.content);
    if (const auto* n = std::get_if<record::Number>(&entry.content); n && n->error)
      out[record::error_name(entry.name).c_str()] = number(*n->error, false);
  }
  return out;
}

py::dict columns_of(const record::Table& table) {
  py::dict out;
  for (const record::Column& column : table.columns)
    out[column.name.c_str()] = array(column.values);
  return out;
}

} // namespace bem_contact
