// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/formula_printer.hpp"

#include <gtest/gtest.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/emission/cpp_names.hpp"
#include "torsor/generator/listing/generation_constant.hpp"
#include "torsor/generator/mechanics/scene.hpp"

namespace torsor::formula_printer_test {
namespace {

TEST(Literal, IsTheShortestTextThatReadsBack) {
  EXPECT_EQ(literal(Number::rational(981, 100).to_double()), "9.81");
  EXPECT_EQ(literal(Number::rational(981, 100).to_float()), "9.81f");
  EXPECT_EQ(literal(Number(2).to_double()), "2.0");
  EXPECT_EQ(literal(Number(2).to_float()), "2.0f");
  EXPECT_EQ(literal(Number(10).pow(30).to_double()), "1e+30");
  EXPECT_EQ(literal(Number::rational(1, 3).to_double()), "0.3333333333333333");
  EXPECT_EQ(literal(Number::rational(1, 3).to_float()), "0.33333334f");
}

TEST(Literal, HasNoTextOfItsOwnBeyondTheRangeOfItsFormat) {
  EXPECT_EQ(literal(Number(10).pow(40).to_float()), "HUGE_VALF");
  EXPECT_EQ(literal(Number(-10).pow(401).to_double()), "-HUGE_VAL");
}

TEST(ConstantName, ShowsTheValueWhileItIsShort) {
  EXPECT_EQ(constant_name(Number(2), 7), "n2");
  EXPECT_EQ(constant_name(Number::rational(981, 100), 7), "n9_81");
  EXPECT_EQ(constant_name(Number::rational(1, 100), 7), "n0_01");
  EXPECT_EQ(constant_name(Number::rational(13, 10), 7), "n1_3");
  EXPECT_EQ(constant_name(Number::rational(1, 3), 7), "n1_over_3");
  EXPECT_EQ(constant_name(Number::rational(1000001, 3), 7), "k7");
  EXPECT_EQ(constant_name(Number::sqrt2(), 7), "k7");
}

class FormulaPrinterText : public testing::Test {
 protected:
  FormulaPrinter printer() {
    return {[this](ValueNumber value_number) { return local_name(program_, value_number); },
            [](Function function) { return traits_of(function).emitted.cpp; }};
  }
  std::string print(const Value& value) {
    FormulaPrinter printer = this->printer();
    return printer.print(factored(value.polynomial()));
  }
  Scene scene_{"printed"};
  Program program_;
  Value x_ = program_.lower(scene_.coordinate("x", "1"));
  Value y_ = program_.lower(scene_.coordinate("y", "1"));
  Value k_ = program_.lower(scene_.parameter("k", "1"));
};

TEST_F(FormulaPrinterText, WritesProductsQuotientsAndSums) {
  EXPECT_EQ(print(x_ * y_), "q_x * q_y");
  EXPECT_EQ(print(x_ * x_ * x_), "q_x * q_x * q_x");
  EXPECT_EQ(print(x_ - y_), "q_x - q_y");
  EXPECT_EQ(print(-x_ - y_), "-q_x - q_y");
  EXPECT_EQ(print(Number::rational(1, 2) * k_ * x_), "n0_5 * q_x * p_k");
  EXPECT_EQ(print(program_.number(Number(1)) / x_), "n1 / q_x");
}

TEST_F(FormulaPrinterText, PutsParenthesesWhereTheTreeNeedsThem) {
  EXPECT_EQ(print(x_ / (y_ * k_)), "q_x / (q_y * p_k)");
  EXPECT_EQ(print(x_ * y_ / k_), "q_x * q_y / p_k");
  EXPECT_EQ(print(x_ * y_ + x_ * k_), "q_x * (q_y + p_k)");
}

TEST_F(FormulaPrinterText, KeepsSumsInsideSumsAndSignsOfNumbers) {
  Formula outer;
  outer.kind = Formula::Kind::sum;
  outer.children = {factored(k_.polynomial()), factored((x_ + y_).polynomial())};
  outer.negative = {false, true};
  EXPECT_EQ(printer().print(outer), "p_k - (q_x + q_y)");
  Formula quotient;
  quotient.kind = Formula::Kind::quotient;
  quotient.children = {factored((x_ + y_).polynomial()), factored((x_ * k_).polynomial())};
  EXPECT_EQ(printer().print(quotient), "(q_x + q_y) / (q_x * p_k)");
  EXPECT_EQ(printer().print(Formula::of_number(Number(-2))), "-n2");
}

TEST_F(FormulaPrinterText, TurnsTheSignsOfASumRoundInsteadOfNegatingIt) {
  FormulaPrinter printer = this->printer();
  EXPECT_EQ(printer.print_negated(factored((x_ - y_).polynomial())), "-q_x + q_y");
  EXPECT_EQ(printer.print_negated(factored((x_ * y_).polynomial())), "-q_x * q_y");
}

TEST(Wrapped, BreaksBeforeOperatorsAndAfterCommasOnly) {
  const std::string word(50, 'a');
  EXPECT_EQ(wrapped(word + " + " + word + " + " + word, 0), word + " + " + word + "\n    + " + word);
  EXPECT_EQ(wrapped("f(" + word + ", " + word + ", std::array<Scalar, 9>& mass) noexcept", 0),
            "f(" + word + ", " + word + ",\n    std::array<Scalar, 9>& mass) noexcept");
  EXPECT_EQ(wrapped("short", 4), "short");
}

TEST(CppName, RefusesWhatCannotStandInAHeader) {
  const auto message_of = [](const std::string& name, const std::string& what) -> std::string {
    try {
      require_cpp_name(name, what);
    } catch (const SceneError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(
      message_of("operator", "parameter"),
      "the name 'operator' of a parameter is a C++ keyword and cannot stand in a generated header: choose another "
      "name");
  EXPECT_NE(message_of("Scalar", "coordinate").find("is used by the header itself"), std::string::npos);
  EXPECT_NE(message_of("M_PI", "parameter").find("may be a macro"), std::string::npos);
  EXPECT_NE(message_of("gamma", "scene").find("belongs to the C library"), std::string::npos);
  EXPECT_NE(message_of("left arm", "body").find("is not made of letters"), std::string::npos);
  EXPECT_EQ(message_of("gamma", "parameter"), "no error");
  EXPECT_EQ(message_of("theta_1", "coordinate"), "no error");
}

TEST(CppName, KeepsCommentsOnOneLine) { EXPECT_EQ(comment_text("force\non arm\\"), "force on arm/"); }

TEST(GenerationConstant, IsRoundedOnceForEachFormat) {
  Program program;
  const Value sine = program.sin(program.number(Number::rational(3, 10)));
  const RoundedConstant rounded = rounded_constant(program, *sine.value_number());
  // sin(3/10) = 0.29552020666133957510532..., its series in rational arithmetic; the nearest double is not the sine of
  // the double 0.3, which ends in ...955.
  EXPECT_EQ(rounded.in_double, 0.2955202066613396);
  EXPECT_EQ(rounded.in_float, 0.29552022f);
}

TEST(GenerationConstant, SurvivesCancellation) {
  // x - log(exp(x)) is 0, which no precision shows: it is taken for zero. With 1e-60 more it is 1e-60.
  Program program;
  const Value x = program.number(Number::rational(3, 10));
  const Value logarithm = program.apply(Function::log, program.apply(Function::exp, x));
  const Value zero = program.bind(x - logarithm);
  ASSERT_TRUE(zero.value_number());
  EXPECT_EQ(rounded_constant(program, *zero.value_number()).in_double, 0.0);
  const Value tiny = program.bind(x + program.number(Number(10).pow(-60)) - logarithm);
  ASSERT_TRUE(tiny.value_number());
  EXPECT_EQ(rounded_constant(program, *tiny.value_number()).in_double, 1e-60);
}

TEST(GenerationConstant, NamesAConstantWithoutValue) {
  Program program;
  const Value sine = program.sin(program.number(Number(3)));
  const Value root = program.sqrt(program.number(Number::rational(1, 10)) - sine);  // 0.1 - 0.14112
  try {
    rounded_constant(program, root.polynomial().terms()[0].monomial[0].value_number);
    FAIL() << "the root of a negative number has no value";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("has no value"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace torsor::formula_printer_test
