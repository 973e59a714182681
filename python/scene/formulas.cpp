// SPDX-License-Identifier: GPL-3.0-or-later
// Formulas, numbers and conditions.
#include <cctype>

#include <fmt/format.h>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/base/error.hpp"
#include "python/scene/bindings.hpp"

namespace torsor::python {
namespace {

/// The most digits of a decimal that a person writes; 1/3 and 0.1 + 0.2 have more. Shortest decimals of rounded numbers
/// have 16 or 17 digits, and each digit less is ten times rarer: a guard against chance, no proof.
constexpr std::size_t written_digits = 12;

std::size_t significant_digits(const std::string& text) {
  std::string digits;
  for (const char character : text) {
    if (character == 'e') break;
    if (std::isdigit(static_cast<unsigned char>(character)) != 0) digits += character;
  }
  const std::size_t first = digits.find_first_not_of('0'), last = digits.find_last_not_of('0');
  return first == std::string::npos ? 0 : last - first + 1;
}

Number written_decimal(double value) {
  const std::string text = shortest(value);
  if (significant_digits(text) > written_digits) {
    throw Error(fmt::format("the float {} is a rounded number, which no exact formula should hold by chance: give text or a "
                            "Fraction, use pi and sqrt of torsor.scene, or write quantity({}) where its decimal is meant",
                            text, text));
  }
  return from_double(value);
}

std::string text_of(py::handle object) { return py::str(object).cast<std::string>(); }

/// The decimal digits of an integer, also of one whose class prints otherwise.
std::string digits_of(py::handle integer) {
  PyObject* const digits = PyNumber_ToBase(integer.ptr(), 10);
  if (digits == nullptr) throw py::error_already_set();
  return text_of(py::reinterpret_steal<py::object>(digits));
}

/// Text of Python may hold halves of characters, which no UTF-8 has.
Number number_of_text(py::handle text) {
  Py_ssize_t size = 0;
  if (const char* const bytes = PyUnicode_AsUTF8AndSize(text.ptr(), &size)) {
    return parse_decimal(std::string(bytes, static_cast<std::size_t>(size)));
  }
  PyErr_Clear();
  throw Error(fmt::format("cannot read {} as a number: give digits, e.g. \"9.81\" or \"1/3\"", text_of(py::repr(text))));
}

/// A quotient, e.g. fractions.Fraction. numpy's integers too say that they are rational.
bool is_rational(py::handle object) {
  return py::hasattr(object, "numerator") && py::hasattr(object, "denominator");
}

bool is_decimal(py::handle object) {
  const py::handle type = reinterpret_cast<PyObject*>(Py_TYPE(object.ptr()));
  return py::hasattr(type, "__name__") && text_of(type.attr("__name__")) == "Decimal" && py::hasattr(object, "as_tuple");
}

/// Any number with a unit, also a float with all its digits.
Expression quantity(py::handle value, const std::string& unit) {
  if (PyFloat_Check(value.ptr()) != 0) return Expression::quantity(from_double(value.cast<double>()), Unit::parse(unit));
  const std::optional<Number> number = exact_number(value);
  if (!number) throw py::type_error("quantity takes an int, a float, text, a Fraction or a Decimal, and got " + text_of(py::repr(value)));
  return Expression::quantity(*number, Unit::parse(unit));
}

void bind_expression(py::module_& module) {
  py::class_<Expression> expression(module, "Expression", "A formula of exact numbers and quantities of a scene, with its unit.");
  expression.def(py::init([](const Expression& value) { return value; }), "value"_a)
      .def_property_readonly("unit", [](const Expression& self) { return self.unit().to_string(); }, "In SI base units.")
      .def("__str__", &Expression::to_string)
      .def("__repr__", [](const Expression& self) {
        const std::string unit = self.unit().to_string();
        return unit == "1" ? self.to_string() : fmt::format("{} [{}]", self.to_string(), unit);
      });
  using C = const Expression&;
  const py::is_operator op;
  expression.def("__add__", [](C a, C b) { return a + b; }, op).def("__radd__", [](C a, C b) { return b + a; }, op);
  expression.def("__sub__", [](C a, C b) { return a - b; }, op).def("__rsub__", [](C a, C b) { return b - a; }, op);
  expression.def("__mul__", [](C a, C b) { return a * b; }, op).def("__rmul__", [](C a, C b) { return b * a; }, op);
  expression.def("__truediv__", [](C a, C b) { return a / b; }, op).def("__rtruediv__", [](C a, C b) { return b / a; }, op);
  // Converted, Fraction(1, 3) would be the integer 0.
  expression.def("__pow__", [](C a, int n) { return pow(a, n); }, op, py::arg().noconvert(), "A whole power; sqrt gives roots.");
  expression.def("__neg__", [](C a) { return -a; }).def("__pos__", [](C a) { return a; });
  expression.def("__abs__", [](C a) { return abs(a); });
  expression.def("__lt__", [](C a, C b) { return a < b; }, op).def("__le__", [](C a, C b) { return a <= b; }, op);
  expression.def("__gt__", [](C a, C b) { return a > b; }, op).def("__ge__", [](C a, C b) { return a >= b; }, op);
  const auto compared = [](C, const py::object&) -> bool {
    throw py::type_error("whether two formulas are equal is not known from how they are written: ask whether their difference "
                         "is below a bound by piecewise, or compare their texts by str; `is` compares objects");
  };
  expression.def("__eq__", compared, "other"_a).def("__ne__", compared, "other"_a);
  expression.attr("__hash__") = py::module_::import("builtins").attr("object").attr("__hash__");
  // numpy's numbers leave the operation to the formula, and arrays of formulas are not made by chance.
  expression.attr("__array_ufunc__") = py::none();
  py::class_<Condition>(module, "Condition", "An inequality between two quantities of one unit, for piecewise.")
      .def("__bool__", [](const Condition&) -> bool {
        throw py::type_error("whether this inequality holds is known on a motion only: choose by piecewise, not by if, and or or");
      });
}

void bind_functions(py::module_& module) {
  using C = const Expression&;
  module.def("sin", [](C x) { return sin(x); }, "angle"_a);
  module.def("cos", [](C x) { return cos(x); }, "angle"_a);
  module.def("tan", [](C x) { return tan(x); }, "angle"_a);
  module.def("tanh", [](C x) { return tanh(x); }, "x"_a, "Of an x of any size, without overflow.");
  module.def("exp", [](C x) { return exp(x); }, "x"_a);
  module.def("log", [](C x) { return log(x); }, "x"_a);
  module.def("sqrt", [](C x) { return sqrt(x); }, "x"_a, "The root; that of a unit too.");
  module.def("sign", [](C x) { return sign(x); }, "x"_a, "-1, 0 or 1, of an x of any unit; its derivative is 0.");
  module.def("maximum", [](C a, C b) { return max(a, b); }, "a"_a, "b"_a, "The larger of two quantities of one unit.");
  module.def("minimum", [](C a, C b) { return min(a, b); }, "a"_a, "b"_a, "The smaller of two quantities of one unit.");
  module.def("atan2", [](C y, C x) { return atan2(y, x); }, "y"_a, "x"_a, "The angle in (-pi, pi] from the x axis to (x, y).");
  module.def("rate", [](C formula) { return rate(formula); }, "formula"_a, "The derivative with respect to time, e.g. of a coordinate.");
  module.def("piecewise", &piecewise, "rows"_a, "otherwise"_a,
             "The value of the first row (condition, value) whose condition holds, else `otherwise`.");
  module.def("spline", &spline, "x"_a, "points"_a, "unit"_a = "1", "end_slopes"_a = py::none(),
             "The cubic spline through points (x, y), natural or with slopes at both ends; ordinates have the unit given.");
  module.def("quantity", &quantity, "value"_a, "unit"_a = "1",
             "A number with its unit, e.g. quantity(\"9.81\", \"m/s^2\"). A float is its shortest decimal, whatever its digits.");
  module.attr("pi") = pi();
}

}  // namespace

std::optional<Number> exact_number(py::handle object) {
  PyObject* const raw = object.ptr();
  if (PyBool_Check(raw) != 0) return std::nullopt;
  if (PyUnicode_Check(raw) != 0) return number_of_text(object);
  if (PyFloat_Check(raw) != 0) return written_decimal(object.cast<double>());
  if (PyLong_Check(raw) != 0) return parse_decimal(digits_of(object));
  if (is_decimal(object)) return parse_decimal(text_of(object));
  if (is_rational(object)) return parse_decimal(digits_of(object.attr("numerator")) + "/" + digits_of(object.attr("denominator")));
  return std::nullopt;
}

void bind_formulas(py::module_& module) {
  bind_expression(module);
  bind_functions(module);
}

}  // namespace torsor::python
