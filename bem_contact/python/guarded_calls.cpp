#include "bem_contact/python/guarded_calls.hpp"

#include "bem_contact/python/stoppable.hpp"

namespace py = pybind11;

namespace bem_contact {

namespace {

/// Of pybind11, which calls each function by it.
PyCFunctionWithKeywords dispatcher = nullptr;

PyObject* call_guarded(PyObject* self, PyObject* arguments, PyObject* keywords) {
  const CallFromPython call;
  return dispatcher(self, arguments, keywords);
}

void guard_function(PyObject* function) {
  if (function && PyInstanceMethod_Check(function))
    function = PyInstanceMethod_GET_FUNCTION(function);
  if (!function || !PyCFunction_Check(function))
    return;
  PyMethodDef* definition = reinterpret_cast<PyCFunctionObject*>(function)->m_ml;
  const auto now =
      reinterpret_cast<PyCFunctionWithKeywords>(reinterpret_cast<void (*)()>(definition->ml_meth));
  const bool of_pybind11 = (definition->ml_flags & METH_KEYWORDS) != 0 && now != call_guarded;
  if (!of_pybind11 || (dispatcher && now != dispatcher))
    return;
  dispatcher = now;
  definition->ml_meth = reinterpret_cast<PyCFunction>(reinterpret_cast<void (*)()>(call_guarded));
}

/// Python refuses Class.__new__() where it is not that of the class above: object.__new__() "is not safe".
PyObject* new_object(PyTypeObject* type, PyObject* arguments, PyObject* keywords) {
  const PyTypeObject* base = type;
  while (base->tp_new == new_object)
    base = base->tp_base;
  return base->tp_new(type, arguments, keywords);
}

void guard_class(PyObject* of_module) {
  auto* type = reinterpret_cast<PyTypeObject*>(of_module);
  if (PyType_IsSubtype(type, reinterpret_cast<PyTypeObject*>(PyExc_BaseException)))
    return;
  type->tp_new = new_object;
  for (const auto& [name, member] : py::reinterpret_borrow<py::dict>(type->tp_dict)) {
    guard_function(member.ptr());
    if (PyObject_TypeCheck(member.ptr(), &PyProperty_Type))
      guard_function(py::getattr(member, "fget").ptr());
  }
}

} // namespace

void guard_module(py::module_& module) {
  for (const auto& [name, member] : py::reinterpret_borrow<py::dict>(module.attr("__dict__")))
    if (PyType_Check(member.ptr()))
      guard_class(member.ptr());
    else
      guard_function(member.ptr());
}

} // namespace bem_contact
